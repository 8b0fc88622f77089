//! The performance document: its tables and plots, from what was measured. Text between
//! `<!-- begin:NAME -->` and `<!-- end:NAME -->` is written here, everything else by people.

pub mod data;
pub mod figures;
mod markdown;
pub mod tables;
mod targets;
mod whole;

/// Puts `body` between the markers of `name`, in place of what is there.
///
/// # Errors
///
/// Which marker is missing, or there twice.
pub fn replace(text: &str, name: &str, body: &str) -> Result<String, String> {
    let (begin, end) = (format!("<!-- begin:{name} -->"), format!("<!-- end:{name} -->"));
    for marker in [&begin, &end] {
        match text.matches(marker.as_str()).count() {
            1 => {}
            count => return Err(format!("{marker} is there {count} times, not once")),
        }
    }
    let (before, rest) = text.split_once(&begin).unwrap_or((text, ""));
    let Some((_, after)) = rest.split_once(&end) else {
        return Err(format!("{end} comes before {begin}"));
    };
    Ok(format!("{before}{begin}\n\n{}\n\n{end}{after}", body.trim()))
}

/// The names of all markers of a text.
#[must_use]
pub fn names(text: &str) -> Vec<&str> {
    let begun = text.split("<!-- begin:").skip(1);
    begun.filter_map(|rest| rest.split_once(" -->").map(|(name, _)| name)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "a\n<!-- begin:x -->\nold\n<!-- end:x -->\nb\n<!-- begin:y -->\n<!-- end:y -->\nc\n";

    #[test]
    fn only_what_is_between_the_markers_changes() {
        let text = replace(TEXT, "x", "new\n").unwrap();
        assert_eq!(text, TEXT.replace("old", "\nnew\n"));
        assert_eq!(replace(&text, "x", "new"), Ok(text.clone()));
        assert_eq!(names(&text), ["x", "y"]);
    }

    #[test]
    fn missing_markers_are_told() {
        assert!(replace(TEXT, "z", "").is_err_and(|message| message.contains("begin:z")));
        let twice = TEXT.to_owned() + TEXT;
        assert!(replace(&twice, "x", "").is_err_and(|message| message.contains("2 times")));
        assert!(replace("<!-- end:x --><!-- begin:x -->", "x", "").is_err());
        assert!(replace("<!-- begin:x -->", "x", "").is_err());
    }

    /// What a table or plot is made for has a place in the document, and the other way round.
    #[test]
    fn the_document_has_a_place_for_every_table() {
        let path = crate::options::root().join("docs/performance.md");
        let text = std::fs::read_to_string(path).unwrap();
        assert_eq!(names(&text), tables::ALL.map(|(name, _)| name));
    }
}
