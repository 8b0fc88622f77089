//! What the reference says of a scene: the picture before any rounding, where its vertices are, and the
//! picture of the snapped triangles.

use halfplane::{Standard, State};
use halfplane_measure::clip;
use halfplane_reference::{
    Compare, DepthSpec, NO_ID, Picture, Unsnapped, Viewport, render, snap, to_clip, to_window, unsnapped,
};
use num_traits::ToPrimitive;
use rayon::prelude::*;

use crate::error::ReportError;
use crate::scene::Scene;
use crate::snapped::{self, Whole};

/// Vertices whose exact places are computed, evenly spread over those there are.
const VERTICES: usize = 10_000;

/// The truth of a scene.
#[derive(Debug)]
pub struct Truth {
    /// Before any rounding.
    pub unsnapped: Unsnapped,
    /// Some vertices of triangles that need no clipping.
    pub places: Vec<Place>,
    /// The snapped triangles with 32-bit depth, by the specification.
    pub specified: Picture,
    /// The ids of the triangles that are nearest by the exact depths of the snapped triangles.
    pub nearest: Vec<u32>,
    /// The window triangles.
    pub window: halfplane_reference::Scene,
    state: State<Standard>,
    clip: Vec<[f32; 4]>,
}

/// Where a vertex is.
#[derive(Debug, Clone, Copy)]
pub struct Place {
    /// Its number.
    pub vertex: usize,
    /// The exact window place, in pixels, as the nearest floats.
    pub exact: [f64; 2],
    /// That, snapped exactly to 1/256 px.
    pub snapped: [i64; 2],
}

impl Truth {
    /// Of a scene; `progress` is called with the part that is done, from 0 to 1.
    ///
    /// # Errors
    ///
    /// Where the reference refuses the scene.
    pub fn new(scene: &Scene, progress: &(dyn Fn(f64) + Sync)) -> Result<Self, ReportError> {
        let state = scene.state()?;
        let unsnapped = unsnapped(&scene.model(&scene.indices), &|_| ())?;
        progress(0.4);
        let clip: Vec<_> = scene.positions.iter().map(|&position| clip(position, &scene.matrix)).collect();
        let (window, whole) = snapped::assemble(&clip, &scene.indices, &state, DepthSpec::D32);
        let places = places(scene, &whole);
        progress(0.5);
        let specified = render(&window, Compare::Less, DepthSpec::D32, &|_| ())?;
        progress(1.0);
        let id = |best: &Option<u32>| best.map_or(NO_ID, |best| window.triangles[best as usize].id);
        let nearest = specified.best.iter().map(id).collect();
        Ok(Self { unsnapped, places, specified, nearest, window, state, clip })
    }

    /// The specified picture with 16-bit depth.
    ///
    /// # Errors
    ///
    /// Where the reference refuses the scene.
    pub fn specified16(&self, scene: &Scene) -> Result<Picture, ReportError> {
        let (window, _) = snapped::assemble(&self.clip, &scene.indices, &self.state, DepthSpec::D16);
        Ok(render(&window, Compare::Less, DepthSpec::D16, &|_| ())?)
    }
}

fn places(scene: &Scene, whole: &[Whole]) -> Vec<Place> {
    let mut seen = vec![false; scene.positions.len()];
    let mut vertices = Vec::new();
    for vertex in whole.iter().flat_map(|triangle| triangle.corners) {
        if !std::mem::replace(&mut seen[vertex], true) {
            vertices.push(vertex);
        }
    }
    let viewport = Viewport { x: 0, y: 0, width: scene.size.0, height: scene.size.1 };
    let stride = vertices.len().div_ceil(VERTICES).max(1);
    let chosen: Vec<usize> = vertices.into_iter().step_by(stride).collect();
    let place = |&vertex: &usize| {
        let point = to_window(&to_clip(scene.positions[vertex], &scene.matrix)?, viewport)?.position;
        let exact = [point.x.to_f64()?, point.y.to_f64()?];
        let snapped = [snap(&point.x, 8).to_i64()?, snap(&point.y, 8).to_i64()?];
        Some(Place { vertex, exact, snapped })
    };
    chosen.par_iter().filter_map(place).collect()
}
