//! Every other public function that takes values: what is left when the drawing programs are linked.

#![no_std]
#![no_main]

use halfplane::{
    Compare, Coordinate, Coverage, Cull, D16, Depth, DepthTest, Footprint, Format, Ids, Overlap, Rectangle,
    Region, Sample, Small, Standard, State, Statistics, Tiled, Triangle, Uncertainty, Vertex, Winding,
    blocks, draw, texels, traverse, traverse_conservative, unorm16, unorm32,
};
use halfplane_bare_metal::{input, inputs, output, program};

const WIDTH: u32 = 61;
const HEIGHT: u32 = 15;

fn compare(value: u32) -> Compare {
    match value {
        0 => Compare::Less,
        1 => Compare::LessEqual,
        2 => Compare::Greater,
        3 => Compare::GreaterEqual,
        _ => Compare::Always,
    }
}

fn numbers() -> u64 {
    let float = f32::from_bits(input(20));
    let snapped = Coordinate::<Standard>::snap(float).map_or(0, Coordinate::steps)
        ^ Coordinate::<Small>::snap(float).map_or(0, Coordinate::steps);
    u64::from(unorm16(unorm32(float)))
        + snapped as u64
        + blocks(input(21), input(22)) as u64
        + texels(input(23), input(24)) as u64
        + halfplane::draw::instance_of(&[input(25), input(26)], input(27))
            .map_or(0, |(at, id)| at as u64 + u64::from(id))
}

fn by_hand() -> Option<u64> {
    let region = Region::<Standard>::new(input(25), input(26), input(27), input(28)).ok()?;
    let [a, b, c] = inputs().map(|[x, y, z]| Vertex::new(x as i32, y as i32, z));
    let sample = Sample::new(input(29) as i32, input(30) as i32)?;
    let triangle = Triangle::new([a.ok()?, b.ok()?, c.ok()?], sample)?;
    let mut sum = triangle.weights(input(31), input(32))?.iter().fold(0, |s: i64, w| s ^ w) as u64;
    let _ = traverse(&triangle, region, |x, y, mask| {
        for (column, row) in mask.cells() {
            sum ^= u64::from(x + column) << 32 | u64::from(y + row);
        }
    });
    Some(sum)
}

fn conservative<F: Format>() -> Option<u64> {
    let region = Region::<F>::new(input(25), input(26), input(27), input(28)).ok()?;
    let [a, b, c] = inputs().map(|[x, y, z]| Vertex::new(x as i32, y as i32, z));
    let uncertainty = if input(29) == 0 { Uncertainty::None } else { Uncertainty::HalfStep };
    let footprint = Footprint::new([a.ok()?, b.ok()?, c.ok()?], uncertainty);
    let mut sum = u64::from(footprint.overlap(region) == Overlap::Covers);
    sum += u64::from(footprint.bounds(region).map_or(0, |bounds| bounds.x1()));
    let _ = traverse_conservative(&footprint, region, |x, y, touched, inside| {
        sum ^= u64::from(x ^ y) << 32 | u64::from(touched.0) << 16 | u64::from(inside.0);
    });
    let at = |k| Coordinate::from_steps(input(k) as i32);
    let rectangle = Rectangle::new([at(30)?, at(31)?], [at(32)?, at(33)?]);
    sum += u64::from(rectangle.touched(region, uncertainty).map_or(0, |touched| touched.x0()));
    Some(sum + u64::from(rectangle.inside(region, uncertainty)?.y0()))
}

fn storage() -> Option<u64> {
    let region = Region::<Standard>::new(input(33), input(34), input(35), input(36)).ok()?;
    let mut texel_storage = [0; texels(WIDTH, HEIGHT)];
    let mut mask_storage = [0; blocks(WIDTH, HEIGHT)];
    let mut bits = [0; (WIDTH * HEIGHT) as usize];
    let mut rows = [0; (WIDTH * HEIGHT) as usize];
    let length = input(37) as usize;
    let masks = mask_storage.get_mut(..length)?;
    let coverage = Coverage::new(region, masks).ok()?;
    coverage.to_bits(bits.get_mut(..length)?).ok()?;
    {
        let ids = Ids::new(region, texel_storage.get_mut(..length)?).ok()?;
        ids.to_linear(rows.get_mut(..length)?).ok()?;
    }
    let mut tiled = Tiled::of_texels(region, texel_storage.get_mut(..length)?).ok()?;
    tiled.fill(input(38));
    Some(u64::from(tiled.get(input(39), input(40))?) + u64::from(*rows.get(length)?))
}

fn draws() -> Option<u64> {
    let region = Region::<Standard>::of_size(WIDTH, HEIGHT).ok()?;
    let mut depths = [0; texels(WIDTH, HEIGHT)];
    let test = DepthTest { compare: compare(input(41)), write: input(42) != 0 };
    let mut depth: Depth<'_, Standard, D16> = Depth::new(region, &mut depths, test).ok()?;
    let [a, b, c] = inputs().map(|[x, y, z]| Vertex::new(x as i32, y as i32, z));
    let vertices = [a.ok()?, b.ok()?, c.ok()?];
    let scissor = Region::new(input(43), input(44), input(45), input(46)).ok()?;
    let state = State {
        cull: if input(47) != 0 { Cull::Back } else { Cull::Front },
        front: if input(48) != 0 { Winding::Clockwise } else { Winding::CounterClockwise },
        sample: Sample::new(input(49) as i32, input(50) as i32)?,
        ..State::new(scissor)
    };
    let indices: [u32; 6] = core::array::from_fn(|i| input(51 + i));
    let mut total = Statistics::default();
    total += draw(&vertices[..], indices.get(..input(57) as usize)?, input(58), &state, &mut depth).ok()?;
    Some(u64::from(total.drawn))
}

fn main(_: &mut ()) -> Option<u32> {
    output(numbers());
    output(by_hand().unwrap_or(1));
    output(conservative::<Standard>().unwrap_or(4));
    output(conservative::<Small>().unwrap_or(5));
    output(storage().unwrap_or(2));
    output(draws().unwrap_or(3));
    None
}

program!(main, () = ());
