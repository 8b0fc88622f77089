//! Running the built binary in a folder of its own, and the small files it is fed.
#![allow(dead_code, reason = "every test program uses its own part")]

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use halfplane::{Cull, Region, Standard, State};
use halfplane_cli::camera::{self, Hand, Matrix};
use halfplane_cli::mesh::Mesh;
use halfplane_cli::scene;

/// An empty folder for one test.
pub(crate) struct Folder(PathBuf);

impl Folder {
    pub(crate) fn new(name: &str) -> Self {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        // Left by an earlier run, perhaps.
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    pub(crate) fn path(&self) -> &Path {
        &self.0
    }

    pub(crate) fn write(&self, name: &str, bytes: impl AsRef<[u8]>) {
        fs::write(self.0.join(name), bytes).unwrap();
    }

    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.0.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// A file of 32-bit little-endian numbers.
    pub(crate) fn words(&self, name: &str) -> Vec<u32> {
        words(&self.read(name))
    }

    /// Every file and folder in it, with paths relative to it.
    pub(crate) fn listing(&self) -> Vec<String> {
        let mut found = Vec::new();
        let mut open = vec![self.0.clone()];
        while let Some(folder) = open.pop() {
            for entry in fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                found.push(path.strip_prefix(&self.0).unwrap().display().to_string());
                if path.is_dir() {
                    open.push(path);
                }
            }
        }
        found.sort();
        found
    }

    /// Runs the binary here.
    pub(crate) fn run(&self, arguments: &[&str]) -> Output {
        self.feed(arguments, &[])
    }

    /// Runs the binary here with something on its standard input.
    pub(crate) fn feed(&self, arguments: &[&str], input: &[u8]) -> Output {
        let mut child = Command::new(env!("CARGO_BIN_EXE_halfplane"))
            .args(arguments)
            .current_dir(&self.0)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut stdin = child.stdin.take().unwrap();
        let input = input.to_vec();
        let writer = std::thread::spawn(move || {
            // A command that needs no input does not read it.
            let _ = stdin.write_all(&input);
        });
        let output = child.wait_with_output().unwrap();
        writer.join().unwrap();
        output
    }

    /// As [`run`](Self::run), and it must succeed.
    pub(crate) fn succeed(&self, arguments: &[&str]) -> String {
        let output = self.run(arguments);
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{arguments:?}: {:?} {errors}", output.status);
        assert_eq!(errors, "", "{arguments:?}");
        String::from_utf8(output.stdout).unwrap()
    }
}

pub(crate) fn words(bytes: &[u8]) -> Vec<u32> {
    bytes.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect()
}

pub(crate) fn bytes_of(words: impl IntoIterator<Item = u32>) -> Vec<u8> {
    words.into_iter().flat_map(u32::to_le_bytes).collect()
}

/// An SCN1 file.
pub(crate) fn scn1(vertices: &[[f32; 3]], indices: &[u32]) -> Vec<u8> {
    let mut bytes = b"SCN1".to_vec();
    bytes.extend(bytes_of([vertices.len() as u32, indices.len() as u32]));
    bytes.extend(bytes_of(vertices.iter().flatten().map(|c| c.to_bits())));
    bytes.extend(bytes_of(indices.iter().copied()));
    bytes
}

/// A binary glTF file of a JSON text and a buffer.
pub(crate) fn glb(json: &str, buffer: &[u8]) -> Vec<u8> {
    let padded = |bytes: &[u8], with: u8| {
        let mut bytes = bytes.to_vec();
        bytes.resize(bytes.len().next_multiple_of(4), with);
        bytes
    };
    let (json, buffer) = (padded(json.as_bytes(), b' '), padded(buffer, 0));
    let mut file = b"glTF".to_vec();
    file.extend(bytes_of([2, (12 + 8 + json.len() + 8 + buffer.len()) as u32]));
    file.extend(bytes_of([json.len() as u32]));
    file.extend(b"JSON");
    file.extend(json);
    file.extend(bytes_of([buffer.len() as u32]));
    file.extend(b"BIN\0");
    file.extend(buffer);
    file
}

/// The JSON and the buffer of a glTF mesh with 16-bit indices; `nodes` is the list of nodes, of which
/// the first is the scene's root.
pub(crate) fn gltf_mesh(vertices: &[[f32; 3]], indices: &[u16], nodes: &str, uri: &str) -> (String, Vec<u8>) {
    let mut buffer = bytes_of(vertices.iter().flatten().map(|c| c.to_bits()));
    let positions = buffer.len();
    buffer.extend(indices.iter().flat_map(|i| i.to_le_bytes()));
    let (vertices, indices, length) = (vertices.len(), indices.len(), buffer.len());
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":{nodes},
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],
        "accessors":[
          {{"bufferView":0,"componentType":5126,"count":{vertices},"type":"VEC3","min":[-9,-9,-9],"max":[9,9,9]}},
          {{"bufferView":1,"componentType":5123,"count":{indices},"type":"SCALAR"}}],
        "bufferViews":[
          {{"buffer":0,"byteLength":{positions}}},
          {{"buffer":0,"byteOffset":{positions},"byteLength":{}}}],
        "buffers":[{{{uri}"byteLength":{length}}}]}}"#,
        length - positions
    );
    (json, buffer)
}

/// The identity as `--matrix` takes it: the model is in clip space already, w = 1.
pub(crate) const IDENTITY: &str = "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1";

/// A state that culls back faces, for the built-in scene in a picture of a size.
pub(crate) fn state((width, height): (u32, u32)) -> State<Standard> {
    State { cull: Cull::Back, ..State::new(Region::of_size(width, height).unwrap()) }
}

/// The built-in scene and its first camera's matrix.
pub(crate) fn view(size: (u32, u32)) -> (Mesh, Matrix) {
    let mesh = scene::evening();
    let request = camera::Request { name: Some(scene::CAMERA.to_owned()), ..Default::default() };
    let matrix = camera::choose(&request, &scene::cameras(), scene::NAME, &mesh, Hand::Left, size);
    (mesh, matrix.unwrap())
}
