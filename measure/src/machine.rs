//! What was measured on, by kind: for whoever reads the figures elsewhere.

use std::fs;
use std::process::Command;

use halfplane::simd::Level;

/// Processor, best vector level, system and compiler.
#[must_use]
pub fn describe() -> String {
    let processor = fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| processor(&text));
    let compiler = Command::new("rustc").arg("--version").output().ok();
    let compiler = compiler.and_then(|output| String::from_utf8(output.stdout).ok());
    // `rustc 1.95.0 (hash date)`
    let compiler = compiler.map(|text| text.split(' ').take(2).collect::<Vec<_>>().join(" "));
    let parts = [
        processor,
        Some(std::env::consts::ARCH.to_owned()),
        Some(Level::detect().name().to_owned()),
        Some(std::env::consts::OS.to_owned()),
        compiler,
    ];
    parts.into_iter().flatten().filter(|part| !part.trim().is_empty()).collect::<Vec<_>>().join(", ")
}

/// Vendor, family and model, as Linux tells them.
fn processor(text: &str) -> Option<String> {
    let of = |name: &str| {
        let line = text.lines().find(|line| line.split(':').next().is_some_and(|key| key.trim() == name))?;
        line.split_once(':').map(|(_, value)| value.trim())
    };
    let (vendor, family, model) = (of("vendor_id")?, of("cpu family")?, of("model")?);
    let kind = match (vendor, family.parse::<u32>(), model.parse::<u32>()) {
        ("AuthenticAMD", Ok(25), Ok(0x10..=0x1f | 0x60..=0x7f | 0xa0..=0xaf)) => " (Zen 4)",
        ("AuthenticAMD", Ok(25), Ok(_)) => " (Zen 3)",
        ("AuthenticAMD", Ok(26), Ok(_)) => " (Zen 5)",
        _ => "",
    };
    Some(format!("{vendor} family {family} model {model}{kind}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn processors_are_told_by_family() {
        let text =
            "processor : 0\nvendor_id\t: AuthenticAMD\ncpu family\t: 25\nmodel\t\t: 17\nmodel name : X\n";
        assert_eq!(processor(text).as_deref(), Some("AuthenticAMD family 25 model 17 (Zen 4)"));
        assert_eq!(processor("nothing"), None);
        assert!(describe().contains(Level::detect().name()));
    }
}
