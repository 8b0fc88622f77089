//! Pictures for people, made from depth and ids.

mod depth;
mod ids;
mod light;
mod png;
mod shaded;
mod shadow;
mod zoom;

pub use depth::grey;
pub use ids::{colour_of, colours};
pub use light::Look;
pub use png::{grey16, rgb8};
pub use shaded::shaded;
pub use zoom::Zoom;
