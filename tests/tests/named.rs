//! The cases that the plan for a CPU rasterizer lists, each by its name.

#[path = "named/camera.rs"]
mod camera;
#[path = "named/depth_order.rs"]
mod depth_order;
#[path = "named/fullscreen.rs"]
mod fullscreen;
