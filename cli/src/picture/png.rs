//! PNG files in memory.

use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};

/// A picture of 16-bit greys.
#[must_use]
pub fn grey16(width: u32, height: u32, greys: &[u16]) -> Vec<u8> {
    // The encoder takes 16-bit samples in the machine's byte order.
    let bytes: Vec<u8> = greys.iter().flat_map(|grey| grey.to_ne_bytes()).collect();
    encode(width, height, &bytes, ExtendedColorType::L16)
}

/// A picture of red, green and blue.
#[must_use]
pub fn rgb8(width: u32, height: u32, colours: &[[u8; 3]]) -> Vec<u8> {
    encode(width, height, colours.as_flattened(), ExtendedColorType::Rgb8)
}

fn encode(width: u32, height: u32, bytes: &[u8], kind: ExtendedColorType) -> Vec<u8> {
    let mut file = Vec::new();
    PngEncoder::new(&mut file)
        .write_image(bytes, width, height, kind)
        .expect("a picture of the stated size and kind always fits in memory");
    file
}
