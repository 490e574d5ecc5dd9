//! The layouts: what they plot is recorded, what they show exists, and they are not too full.

use super::case;
use crate::wire::TRIBODYN_DESCRIPTORS;
use crate::{Layout, LayoutKind};
use prost::Message;
use prost_types::{DescriptorProto, FileDescriptorSet};
use serde_json::Value;
use std::collections::BTreeSet;

/// Kinds of panel that Foxglove and Lichtblick both have.
const KINDS: [&str; 7] = ["3D", "Plot", "RosOut", "RawMessages", "StateTransitions", "Tab", "Table"];

fn layout(kind: LayoutKind) -> Value {
    let case::Made { name, inputs, .. } = case::case(9);
    let text = Layout::new(kind, &name, &inputs.bearing.geometry, &inputs.speeds).json();
    serde_json::from_str(&text).unwrap()
}

fn descriptor(name: &str) -> DescriptorProto {
    let set = FileDescriptorSet::decode(TRIBODYN_DESCRIPTORS).unwrap();
    set.file.into_iter().flat_map(|file| file.message_type).find(|m| m.name() == name).unwrap()
}

fn has(message: &str, field: &str) -> bool {
    descriptor(message).field.iter().any(|f| f.name() == field)
}

/// The type of the messages of a topic.
fn message(kind: LayoutKind, topic: &str) -> &'static str {
    match (kind, topic) {
        (LayoutKind::Run, "/bearing/state") => "TransientState",
        (LayoutKind::Solution, "/bearing/state") => "BearingState",
        (_, "/bearing/balls") => "Balls",
        (_, "/bearing/azimuth") => "AroundBearing",
        (LayoutKind::Run, "/bearing/orbit") => "Orbit",
        (LayoutKind::Run, "/bearing/wear") => "Wear",
        (LayoutKind::Run, "/bearing/spectrum" | "/bearing/spectrum/inner" | "/bearing/spectrum/cage") => "Spectrum",
        other => panic!("{other:?} is not recorded"),
    }
}

/// Leaves of a tree of panels.
fn leaves(tree: &Value, found: &mut Vec<String>) {
    match tree {
        Value::String(id) => found.push(id.clone()),
        tree => ["first", "second"].iter().for_each(|side| leaves(&tree[side], found)),
    }
}

#[test]
fn identity_layouts_plot_what_is_recorded() {
    for (kind, least) in [(LayoutKind::Run, 60), (LayoutKind::Solution, 15)] {
        let layout = layout(kind);
        let mut plotted = 0;
        for (id, panel) in layout["configById"].as_object().unwrap() {
            assert_eq!(panel["foxglovePanelTitle"], panel["lichtblickPanelTitle"], "{id}");
            let along = panel.get("xAxisPath").into_iter();
            for path in panel["paths"].as_array().into_iter().flatten().chain(along) {
                let value = path["value"].as_str().unwrap();
                let (topic, rest) = value.split_once('.').unwrap();
                let message = message(kind, topic);
                match rest.split_once("].") {
                    Some((ball, field)) => {
                        let ball: usize = ball.strip_prefix("balls[").unwrap().parse().unwrap();
                        assert!(ball < 9 && has("Ball", field), "{value}");
                    }
                    None => assert!(has(message, rest.trim_end_matches("[:]")), "{value}"),
                }
                plotted += 1;
            }
        }
        assert!(plotted >= least, "{plotted}");
        assert_eq!(layout["playbackConfig"]["speed"], 0.01);
        assert_eq!(layout["configById"]["3D!bearing"]["cameraState"]["near"], 0.001);
    }
}

#[test]
fn identity_every_panel_is_shown_once_and_at_most_eight_at_a_time() {
    for kind in [LayoutKind::Run, LayoutKind::Solution] {
        let layout = layout(kind);
        let panels = layout["configById"].as_object().unwrap();
        let mut shown = Vec::new();
        leaves(&layout["layout"], &mut shown);
        let besides = shown.iter().filter(|id| !id.starts_with("Tab!")).count();
        for tab in panels["Tab!main"]["tabs"].as_array().unwrap() {
            let mut page = Vec::new();
            leaves(&tab["layout"], &mut page);
            assert!(page.len() + besides <= 8, "{}: {page:?}", tab["title"]);
            shown.extend(page);
        }
        let ids: BTreeSet<&String> = shown.iter().collect();
        assert_eq!(ids.len(), shown.len(), "a panel is shown twice: {shown:?}");
        assert!(ids.iter().all(|id| panels.contains_key(*id)) && ids.len() == panels.len());
        assert!(ids.iter().all(|id| KINDS.contains(&id.split('!').next().unwrap())));
    }
}

/// A floating legend hides up to half of a small plot, and a number without unit says nothing.
#[test]
fn identity_plots_have_units_and_legends_that_hide_nothing() {
    for kind in [LayoutKind::Run, LayoutKind::Solution] {
        for (id, panel) in layout(kind)["configById"].as_object().unwrap() {
            if !id.starts_with("Plot!") {
                continue;
            }
            assert!(["left", "none"].contains(&panel["legendDisplay"].as_str().unwrap()), "{id}");
            for axis in ["xAxisLabel", "yAxisLabel", "foxglovePanelTitle"] {
                let text = panel[axis].as_str().unwrap();
                assert!(text.contains('[') && text.ends_with(']'), "{id}: {axis} {text}");
            }
        }
    }
}

#[test]
fn limit_the_layout_fits_the_bearing() {
    let fitted = layout(LayoutKind::Run);
    let rows = |layout: &Value| layout["configById"]["StateTransitions!motion"]["paths"].as_array().unwrap().len();
    assert_eq!(rows(&fitted), 9);
    let general: Value = serde_json::from_str(&Layout::general(LayoutKind::Run).json()).unwrap();
    assert_eq!(rows(&general), 13);
    // 9 balls of 30.16 mm on 167.5 mm at 18° and 14 000 r/min: 1230 Hz pass the inner race, four times that is 4.9 kHz.
    assert_eq!(fitted["configById"]["Plot!spectrum_outer"]["maxXValue"], 5000.0);
}
