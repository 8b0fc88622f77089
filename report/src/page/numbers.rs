//! Numbers as people read them.

/// Three or four figures that matter; whole numbers whole, with thin spaces between thousands.
pub(super) fn figure(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return if value.is_nan() { "not a number".to_owned() } else { "∞".to_owned() };
    }
    let size = value.abs();
    if value.fract() == 0.0 && size < 1e9 {
        return grouped(value as i64);
    }
    if !(1e-4..1e9).contains(&size) {
        let exponent = size.log10().floor();
        return format!("{:.2}·10{}", value / 10f64.powf(exponent), raised(exponent as i32));
    }
    let digits = (3.0 - size.log10().floor()).clamp(0.0, 7.0) as usize;
    if size >= 10_000.0 { grouped(value.round() as i64) } else { format!("{value:.digits$}") }
}

/// Milliseconds.
pub(super) fn ms(value: f64) -> String {
    match value {
        v if v >= 99.95 => format!("{v:.0}"),
        v if v >= 9.995 => format!("{v:.1}"),
        v if v >= 0.9995 => format!("{v:.2}"),
        v => format!("{v:.3}"),
    }
}

/// Bytes in KiB or MiB.
pub(super) fn bytes(value: usize) -> String {
    let kib = value as f64 / 1024.0;
    match value {
        0..1024 => format!("{value} B"),
        1024..1_048_576 => format!("{kib:.1} KiB"),
        _ => format!("{:.2} MiB", kib / 1024.0),
    }
}

fn grouped(value: i64) -> String {
    let digits = value.unsigned_abs().to_string();
    let mut text = if value < 0 { "-".to_owned() } else { String::new() };
    for (place, digit) in digits.chars().enumerate() {
        // From 10 000 on.
        if place > 0 && digits.len() > 4 && (digits.len() - place).is_multiple_of(3) {
            text.push('\u{2009}');
        }
        text.push(digit);
    }
    text
}

fn raised(exponent: i32) -> String {
    let digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let sign = if exponent < 0 { "⁻" } else { "" };
    let shown = exponent.unsigned_abs().to_string();
    let shown = shown.bytes().filter_map(|digit| digits.get(usize::from(digit - b'0')));
    format!("{sign}{}", shown.collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_short_and_whole_numbers_whole() {
        let shown =
            [0.0, 7.0, 1234.0, 12_345.0, -1_234_567.0, 0.99912, 65_536.4, 0.000_012, 4.2e12].map(figure);
        let expected = [
            "0",
            "7",
            "1234",
            "12\u{2009}345",
            "-1\u{2009}234\u{2009}567",
            "0.9991",
            "65\u{2009}536",
            "1.20·10⁻⁵",
            "4.20·10¹²",
        ];
        assert_eq!(shown, expected);
        assert_eq!([f64::NAN, f64::INFINITY].map(figure), ["not a number", "∞"]);
        assert_eq!([0.0514, 1.34, 27.31, 1234.5].map(ms), ["0.051", "1.34", "27.3", "1234"]);
        assert_eq!([17, 2048, 3 << 20].map(bytes), ["17 B", "2.0 KiB", "3.00 MiB"]);
    }
}
