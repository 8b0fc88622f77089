//! What `bench` prints: a table for people, JSON for programs.

use std::fmt::Write as _;

use halfplane::simd::Occlusion;

use super::{Limits, Outcome};
use crate::args::Attachments;
use crate::measure::protocol::Summary;
use crate::target::Preparation;

impl Outcome {
    /// A time in clears: of minima.
    #[must_use]
    pub fn clears(&self, summary: &Summary) -> f64 {
        summary.min / self.limits.clear.min
    }

    /// The table.
    #[must_use]
    pub fn table(&self) -> String {
        let (width, height) = self.size;
        let Limits { clear, read_modify_write, transform } = &self.limits;
        let bits = self.depth_bits;
        let written = match self.attachments {
            Attachments::Depth => format!("depth in {bits} bits"),
            Attachments::DepthIds => format!("depth in {bits} bits and ids"),
            Attachments::Ids | Attachments::Coverage => self.attachments.name().to_owned(),
        };
        let preparation = self.preparation.map_or(String::new(), |preparation| format!("{preparation}\n"));
        let threads =
            if self.threads == 1 { "one thread".to_owned() } else { format!("{} threads", self.threads) };
        let asked = self.asked.map_or(String::new(), |asked| format!("{}\n", said(&asked)));
        let camera = if self.moving { "moving" } else { "standing still" };
        let mut text = format!(
            "{}: {} triangles, {} vertices\n{width}x{height} pixels, {} covered, {written}, level {}\n{preparation}{}\n{asked}\
             {threads}; camera {camera}; {} frames measured after {} to warm up; times in ms\n\n",
            self.scene,
            self.triangles,
            self.vertices,
            self.covered,
            self.level,
            self.statistics,
            self.frame.frames,
            self.warm_up,
        );
        let rows = [
            ("frame: clear, transform, draw", &self.frame),
            ("limit: clear of 1280x720 u32", clear),
            ("limit: read-modify-write of them", read_modify_write),
            ("limit: vertex stage alone", transform),
        ];
        let _ = writeln!(
            text,
            "{:32} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>8}",
            "", "min", "25 %", "median", "75 %", "max", "mean", "sdev", "clears"
        );
        for (name, s) in rows {
            let _ = writeln!(
                text,
                "{name:32} {:9.4} {:9.4} {:9.4} {:9.4} {:9.4} {:9.4} {:9.4} {:8.2}",
                s.min,
                s.p25,
                s.median,
                s.p75,
                s.max,
                s.mean,
                s.sdev,
                self.clears(s)
            );
        }
        text
    }

    /// One JSON object in one line. All names ending in `_ms` are milliseconds; limits are minima. What is
    /// said of meshlets is absent where there are none.
    #[must_use]
    pub fn json(&self) -> String {
        let (width, height) = self.size;
        let Limits { clear, read_modify_write, transform } = &self.limits;
        let s = &self.frame;
        let mut text = String::from("{");
        let _ = write!(text, "\"scene\":{},\"size\":\"{width}x{height}\"", string(&self.scene));
        let _ = write!(text, ",\"level\":\"{}\",\"attachments\":\"{}\"", self.level, self.attachments.name());
        let _ = write!(text, ",\"depth_bits\":{},\"moving\":{}", self.depth_bits, self.moving);
        let _ = write!(text, ",\"frames\":{},\"warm_up\":{}", s.frames, self.warm_up);
        let _ = write!(text, ",\"triangles\":{},\"vertices\":{}", self.triangles, self.vertices);
        let _ = write!(text, ",\"drawn\":{},\"covered\":{}", self.statistics.drawn, self.covered);
        let _ = write!(text, ",\"threads\":{}", self.threads);
        if let Some(Occlusion { batches, hidden_batches, facing_meshlets, meshlets, hidden_meshlets }) =
            self.asked
        {
            let _ = write!(text, ",\"batches\":{batches},\"hidden_batches\":{hidden_batches}");
            let _ = write!(text, ",\"facing_meshlets\":{facing_meshlets}");
            let _ = write!(text, ",\"tested_meshlets\":{meshlets},\"hidden_meshlets\":{hidden_meshlets}");
        }
        if let Some(Preparation { meshlets, ms, bytes }) = self.preparation {
            let _ = write!(text, ",\"meshlets\":{meshlets},\"prepare_ms\":{ms:.6},\"meshlet_bytes\":{bytes}");
        }
        for (name, time) in [
            ("min_ms", s.min),
            ("p25_ms", s.p25),
            ("median_ms", s.median),
            ("p75_ms", s.p75),
            ("max_ms", s.max),
            ("mean_ms", s.mean),
            ("sdev_ms", s.sdev),
        ] {
            let _ = write!(text, ",\"{name}\":{time:.6}");
        }
        let _ = writeln!(
            text,
            ",\"clears\":{:.4},\"limits\":{{\"clear_ms\":{:.6},\"rmw_ms\":{:.6},\"transform_ms\":{:.6}}}}}",
            self.clears(s),
            clear.min,
            read_modify_write.min,
            transform.min
        );
        text
    }
}

/// What was asked, in a line.
fn said(asked: &Occlusion) -> String {
    let Occlusion { batches, hidden_batches, facing_meshlets, meshlets, hidden_meshlets } = asked;
    format!(
        "asked: batches {batches}, hidden {hidden_batches}; meshlets of the others {meshlets}, hidden {hidden_meshlets}; \
         not asked: {facing_meshlets} facing away"
    )
}

/// A text as JSON writes it.
fn string(text: &str) -> String {
    let mut quoted = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' | '\\' => quoted.extend(['\\', letter]),
            control if u32::from(control) < 0x20 => {
                let _ = write!(quoted, "\\u{:04x}", u32::from(control));
            }
            other => quoted.push(other),
        }
    }
    quoted.push('"');
    quoted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_text_is_a_json_string() {
        for text in ["plain.obj", "a \"b\"\\c\n\t\u{1}", "Äpfel \u{1F34F} \u{7f}"] {
            let parsed: gltf::json::Value =
                gltf::json::deserialize::from_str(&string(text)).expect("a JSON string");
            assert_eq!(parsed, gltf::json::Value::from(text));
        }
    }
}
