//! Results reach the disk whole or not at all.
//!
//! Every file is first written under a temporary name in the folder it belongs to. Only when all of
//! them are complete are they renamed, so a full disk or a missing permission leaves nothing behind.

use std::fmt;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// A set of files for one folder, written together by [`Outputs::commit`].
#[derive(Debug)]
pub struct Outputs {
    folder: PathBuf,
    files: Vec<(String, Vec<u8>)>,
}

/// A result that could not be written.
#[derive(Debug)]
pub struct OutputError {
    path: PathBuf,
    problem: Problem,
}

#[derive(Debug)]
enum Problem {
    Folder(io::Error),
    IsFolder,
    Write(io::Error),
    Print(io::Error),
}

impl Outputs {
    /// An empty set for `folder`, which need not exist yet.
    #[must_use]
    pub fn new(folder: &Path) -> Self {
        Self { folder: folder.to_owned(), files: Vec::new() }
    }

    /// Adds one file; nothing is written yet.
    pub fn add(&mut self, name: &str, bytes: Vec<u8>) {
        self.files.push((name.to_owned(), bytes));
    }

    /// The paths the files will have.
    pub fn paths(&self) -> impl Iterator<Item = PathBuf> + '_ {
        self.files.iter().map(|(name, _)| self.folder.join(name))
    }

    /// Writes all the files, replacing older ones of the same names.
    ///
    /// # Errors
    ///
    /// [`OutputError`] names the file or folder. No temporary file is left, and no older file has
    /// been replaced unless the failure came while renaming.
    pub fn commit(self) -> Result<(), OutputError> {
        let made = Folder::make(&self.folder)?;
        let mut temporaries = Temporaries(Vec::new());
        for (name, bytes) in &self.files {
            let path = self.folder.join(name);
            if path.is_dir() {
                return Err(OutputError { path, problem: Problem::IsFolder });
            }
            let temporary = self.folder.join(format!(".{name}.{}.tmp", std::process::id()));
            temporaries.0.push(temporary.clone());
            write_all(&temporary, bytes)
                .map_err(|error| OutputError { path, problem: Problem::Write(error) })?;
        }
        for (temporary, (name, _)) in temporaries.0.iter().zip(&self.files) {
            let path = self.folder.join(name);
            fs::rename(temporary, &path)
                .map_err(|error| OutputError { path, problem: Problem::Write(error) })?;
        }
        made.keep();
        Ok(())
    }
}

impl OutputError {
    /// Standard output that does not take what is printed.
    #[must_use]
    pub fn print(error: io::Error) -> Self {
        Self { path: PathBuf::from("standard output"), problem: Problem::Print(error) }
    }
}

fn write_all(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = fs::File::create(path)?;
    file.write_all(bytes)?;
    file.flush()
}

/// The temporary files of one commit; those not renamed are removed at the end.
struct Temporaries(Vec<PathBuf>);

impl Drop for Temporaries {
    fn drop(&mut self) {
        for path in &self.0 {
            // Already renamed, or never made: nothing to remove.
            let _ = fs::remove_file(path);
        }
    }
}

/// The output folder; removed again when it was made for a commit that failed.
struct Folder {
    made: Option<PathBuf>,
}

impl Folder {
    fn make(path: &Path) -> Result<Self, OutputError> {
        let made = (!path.exists()).then(|| path.to_owned());
        fs::create_dir_all(path)
            .map_err(|error| OutputError { path: path.to_owned(), problem: Problem::Folder(error) })?;
        Ok(Self { made })
    }

    fn keep(mut self) {
        self.made = None;
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        if let Some(path) = &self.made {
            // Only succeeds while the folder is empty.
            let _ = fs::remove_dir(path);
        }
    }
}

impl fmt::Display for OutputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let path = self.path.display();
        match &self.problem {
            Problem::Folder(error) => {
                write!(
                    f,
                    "cannot make the output folder {path}: {error}; --out takes a folder that exists or can be made"
                )
            }
            Problem::IsFolder => {
                write!(f, "cannot write {path}: a folder has that name; move it or choose another --out")
            }
            Problem::Write(error) => {
                write!(
                    f,
                    "cannot write {path}: {error}; --out takes a folder with room that may be written to"
                )
            }
            Problem::Print(error) => write!(f, "cannot write to {path}: {error}"),
        }
    }
}

impl std::error::Error for OutputError {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_made_for_nothing_is_removed_again() {
        let folder = std::env::temp_dir().join(format!("halfplane-output-{}", std::process::id()));
        let mut outputs = Outputs::new(&folder);
        outputs.add("first", vec![1]);
        // The temporary name of this one lies in a folder that is not there.
        outputs.add("missing/second", vec![2]);
        let error = outputs.commit().unwrap_err().to_string();
        assert!(error.contains("second"), "{error}");
        assert!(!folder.exists());
    }
}
