//! Lines through points, both axes logarithmic.

use std::path::Path;

use plotters::prelude::*;

use super::{Error, FAINT, INK, colour, power};

/// A line.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// What it is of.
    pub name: String,
    /// Its points, by their first coordinate.
    pub points: Vec<(f64, f64)>,
    /// Nothing measured but something to compare with: grey, dashed and without dots.
    pub reference: bool,
}

const SIZE: (u32, u32) = (960, 560);

/// Draws the curves.
///
/// # Errors
///
/// What the file system or plotters says.
pub fn draw(path: &Path, title: &str, axes: [&str; 2], curves: &[Curve]) -> Result<(), Error> {
    let root = SVGBackend::new(path, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let range = |of: fn(&(f64, f64)) -> f64| {
        let (low, high) =
            points().map(of).fold((f64::INFINITY, 0.0), |(low, high), v| (v.min(low), v.max(high)));
        (low / 1.5, high * 1.5)
    };
    let (x, y) = (range(|point| point.0), range(|point| point.1));
    let mut chart = ChartBuilder::on(&root)
        .margin(16)
        .margin_right(28)
        .caption(title, ("sans-serif", 20).into_font().color(&INK))
        .x_label_area_size(44)
        .y_label_area_size(64)
        .build_cartesian_2d((x.0..x.1).log_scale(), (y.0..y.1).log_scale())?;
    chart
        .configure_mesh()
        .bold_line_style(FAINT)
        .light_line_style(RGBColor(240, 240, 240))
        .axis_style(INK)
        .label_style(("sans-serif", 15).into_font().color(&INK))
        .axis_desc_style(("sans-serif", 16).into_font().color(&INK))
        .x_desc(axes[0])
        .y_desc(axes[1])
        .x_label_formatter(&|value| power(*value))
        .y_label_formatter(&|value| power(*value))
        .draw()?;
    for (place, curve) in curves.iter().enumerate() {
        let colour = if curve.reference { INK } else { colour(place) };
        let points = curve.points.iter().copied();
        if curve.reference {
            let series = DashedLineSeries::new(points, 6, 5, colour.stroke_width(1));
            chart
                .draw_series(series)?
                .label(curve.name.clone())
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 24, y)], colour));
        } else {
            chart
                .draw_series(LineSeries::new(points.clone(), colour.stroke_width(2)))?
                .label(curve.name.clone())
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 24, y)], colour.stroke_width(2)));
            chart.draw_series(points.map(|point| Circle::new(point, 3, colour.filled())))?;
        }
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .margin(12)
        .background_style(WHITE.mix(0.9))
        .border_style(FAINT)
        .label_font(("sans-serif", 16).into_font().color(&INK))
        .draw()?;
    root.present()?;
    Ok(())
}
