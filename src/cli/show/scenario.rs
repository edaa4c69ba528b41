//! A page about a scenario: its notes, and what it says.

use serde_json::{Value, json};

use crate::files::Text;
use crate::simulation::Session;

/// The comment at its head as notes, then its keys as they are written.
pub(super) fn text(session: &Session, file: &Text) -> String {
    let title = &session.scenario().title;
    let (notes, keys) = parts(&file.text);
    let mut page = format!("scenario {}\n", session.scenario_name().unwrap_or_default());
    if !title.is_empty() {
        page.push_str(&format!("{title}\n"));
    }
    if !notes.is_empty() {
        page.push_str(&format!("\n{notes}"));
    }
    page + "\n" + &keys
}

/// The same as JSON, the keys under `keys`.
pub(super) fn object(session: &Session, file: &Text) -> Value {
    let (notes, _) = parts(&file.text);
    let keys: toml::Table = toml::from_str(&file.text).unwrap_or_default();
    json!({
        "kind": "scenario",
        "name": session.scenario_name(),
        "title": session.scenario().title,
        "notes": notes,
        "circuit": session.circuit().name(),
        "keys": keys,
    })
}

/// The comment that a scenario opens with, without its signs, and the rest.
fn parts(text: &str) -> (String, String) {
    let lines: Vec<_> = text.lines().skip_while(|line| line.trim().is_empty()).collect();
    let comment = lines.iter().take_while(|line| line.starts_with('#')).count();
    let notes = lines[..comment].iter().map(|line| line.trim_start_matches('#').trim().to_owned() + "\n").collect();
    let keys = lines[comment..].iter().map(|line| (*line).to_owned() + "\n").collect::<String>();
    (notes, keys.trim_start().to_owned())
}
