//! What plots that live in a page share: colours that follow the page, and a name for those who cannot see them.

use plotters::prelude::*;

use super::{Error, PALETTE};

/// A colour by its part in a plot. Drawn with a stand-in that is replaced in the end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// Letters and axes.
    Ink,
    /// Lines of the grid.
    Grid,
    /// What is drawn on.
    Paper,
    /// A series, by its place in the palette.
    Series(usize),
}

/// Names of the page's variables, and what they are in a plot that stands alone.
const FIXED: [(&str, &str); 3] = [("ink", "#1e1e1e"), ("grid", "#dcdcdc"), ("paper", "#ffffff")];

impl Role {
    /// The colour to draw with.
    #[must_use]
    pub fn stand_in(self) -> RGBColor {
        let place = match self {
            Self::Ink => 0,
            Self::Grid => 1,
            Self::Paper => 2,
            Self::Series(place) => 3 + place % PALETTE.len(),
        };
        RGBColor(1, 2, place as u8)
    }
}

/// Where a plot is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// In a page whose style has the variables `--ink`, `--grid`, `--paper` and `--series-0` to `-7`.
    Page,
    /// By itself, on white.
    Alone,
}

/// Draws in pixels on a paper of that size.
///
/// # Errors
///
/// What plotters says.
pub fn draw(
    size: (u32, u32),
    title: &str,
    place: Place,
    paint: impl FnOnce(&DrawingArea<SVGBackend<'_>, plotters::coord::Shift>) -> Result<(), Error>,
) -> Result<String, Error> {
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        root.fill(&Role::Paper.stand_in())?;
        paint(&root)?;
        root.present()?;
    }
    Ok(finish(&svg, title, place))
}

/// Puts real colours for the stand-ins, and a title in.
fn finish(svg: &str, title: &str, place: Place) -> String {
    let mut svg = svg.to_owned();
    for number in 0..3 + PALETTE.len() {
        let (name, fixed) = match number {
            0..3 => (FIXED[number].0.to_owned(), FIXED[number].1.to_owned()),
            _ => {
                let RGBColor(red, green, blue) = PALETTE[number - 3];
                (format!("series-{}", number - 3), format!("#{red:02x}{green:02x}{blue:02x}"))
            }
        };
        let stand_in = format!("#0102{number:02X}");
        for property in ["fill", "stroke"] {
            let drawn = format!("{property}=\"{stand_in}\"");
            let meant = match place {
                Place::Page => format!("style=\"{property}:var(--{name})\""),
                Place::Alone => format!("{property}=\"{fixed}\""),
            };
            svg = svg.replace(&drawn, &meant);
        }
    }
    let start = svg.find("<svg ").unwrap_or(0);
    let svg = &svg[start..];
    let title = super::escaped(title);
    let named = svg.replacen("<svg ", "<svg role=\"img\" ", 1);
    named.replacen(">", &format!(">\n<title>{title}</title>"), 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_the_pages_or_fixed_ones() {
        let of = |place| {
            draw((50, 40), "a < b", place, |root| {
                root.draw(&Circle::new((9, 9), 3, Role::Series(1).stand_in().filled()))?;
                Ok(())
            })
            .unwrap()
        };
        let (page, alone) = (of(Place::Page), of(Place::Alone));
        assert!(page.starts_with("<svg role=\"img\" ") && page.contains("<title>a &lt; b</title>"), "{page}");
        assert!(page.contains("fill:var(--series-1)") && page.contains("fill:var(--paper)"), "{page}");
        assert!(alone.contains("#d55e00") && alone.contains("#ffffff"), "{alone}");
        assert!(!page.contains("#0102") && !alone.contains("#0102"));
    }
}
