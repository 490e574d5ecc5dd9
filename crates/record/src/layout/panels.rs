//! The kinds of panel, with the settings that viewers read.

use serde_json::{Value, json};

/// A panel: its identifier, whose first part names the kind, and its settings.
pub(super) struct Panel {
    id: Value,
    settings: Value,
}

impl Panel {
    fn new(kind: &str, name: &str, title: &str, mut settings: Value) -> Self {
        // Each of the viewers has its own name for the title.
        settings["foxglovePanelTitle"] = json!(title);
        settings["lichtblickPanelTitle"] = json!(title);
        Self { id: json!(format!("{kind}!{name}")), settings }
    }

    pub(super) fn id(&self) -> &Value {
        &self.id
    }

    pub(super) fn into_entry(self) -> (String, Value) {
        (self.id.as_str().unwrap_or_default().to_owned(), self.settings)
    }

    /// Shows a part of the axis along which it is plotted.
    pub(super) fn up_to(mut self, highest: f64) -> Self {
        self.settings["minXValue"] = json!(0.0);
        self.settings["maxXValue"] = json!(highest);
        self
    }
}

/// Six colours of Okabe and Ito's palette (2008), told apart with every kind of colour blindness.
pub(super) const COLOURS: [&str; 6] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];
/// Width of a legend beside a plot, pixels; 50 of them are handles and colours.
const LEGEND_WIDTH: usize = 130;

/// A curve: where its values are, and its name in the legend.
pub(super) type Curve<'a> = (&'a str, &'a str);

fn curve(place: usize, (value, label): &Curve, line: f64) -> Value {
    json!({
        "value": value,
        "label": label,
        "color": COLOURS[place % COLOURS.len()],
        "enabled": true,
        "showLine": true,
        "lineSize": line,
        "timestampMethod": "receiveTime",
    })
}

/// A title tells what one curve is; several have a legend beside them.
fn legend(settings: &mut Value, curves: usize) {
    settings["showLegend"] = json!(curves > 1);
    settings["legendDisplay"] = json!(if curves > 1 { "left" } else { "none" });
    settings["sidebarDimension"] = json!(LEGEND_WIDTH);
    settings["showPlotValuesInLegend"] = json!(false);
    settings["showXAxisLabels"] = json!(true);
    settings["showYAxisLabels"] = json!(true);
}

/// Curves over simulated time.
pub(super) fn over_time(name: &str, quantity: &str, unit: &str, curves: &[Curve]) -> Panel {
    let mut settings = json!({
        "paths": curves.iter().enumerate().map(|(i, c)| curve(i, c, 1.2)).collect::<Vec<_>>(),
        "xAxisVal": "timestamp",
        "isSynced": true,
        "xAxisLabel": "time [s]",
        "yAxisLabel": format!("[{unit}]"),
    });
    legend(&mut settings, curves.len());
    Panel::new("Plot", name, &format!("{quantity} [{unit}]"), settings)
}

/// Arrays of the latest message, one over the other.
pub(super) fn over_array(
    name: &str,
    (quantity, unit): (&str, &str),
    (along, along_label): (&str, &str),
    curves: &[Curve],
) -> Panel {
    let mut settings = json!({
        "paths": curves.iter().enumerate().map(|(i, c)| curve(i, c, 1.0)).collect::<Vec<_>>(),
        "xAxisVal": "currentCustom",
        "xAxisPath": { "value": along, "enabled": true, "timestampMethod": "receiveTime" },
        "isSynced": false,
        "xAxisLabel": along_label,
        "yAxisLabel": format!("[{unit}]"),
    });
    legend(&mut settings, curves.len());
    Panel::new("Plot", name, &format!("{quantity} [{unit}]"), settings)
}

/// States over time, a row for each.
pub(super) fn states(name: &str, title: &str, paths: &[(String, String)]) -> Panel {
    let path = |(value, label): &(String, String)| json!({ "value": value, "label": label, "enabled": true, "timestampMethod": "receiveTime" });
    let settings = json!({
        "paths": paths.iter().map(path).collect::<Vec<_>>(),
        "isSynced": true,
        "showPoints": false,
        "xAxisLabel": "time [s]",
    });
    Panel::new("StateTransitions", name, title, settings)
}

/// The bearing in three dimensions.
pub(super) fn picture(title: &str, distance: f64) -> Panel {
    let topic = json!({ "visible": true });
    let settings = json!({
        "cameraState": {
            "perspective": true,
            "distance": (distance * 1e4).round() / 1e4,
            "phi": crate::guide::CAMERA_PHI_DEG,
            "thetaOffset": crate::guide::CAMERA_THETA_DEG,
            "target": [0, 0, 0],
            "targetOffset": [0, 0, 0],
            "targetOrientation": [0, 0, 0, 1],
            "fovy": 45,
            // The default of half a metre would cut a bearing away.
            "near": 0.001,
            "far": 100,
        },
        "followMode": "follow-none",
        "followTf": "world",
        "scene": {
            "enableStats": false,
            // Dark text stands on white boxes, which this hides.
            "backgroundColor": "#ffffff",
            "labelScaleFactor": 1,
            "transforms": {
                "enablePreloading": true,
                "showLabel": false,
                "editable": false,
                "axisScale": 0,
                "lineWidth": 0,
                "labelSize": 0.01,
            },
        },
        "transforms": {},
        "topics": { "/bearing/geometry": topic, "/bearing/contacts": topic, "/bearing/coating": topic },
        "layers": {},
        "imageMode": {},
    });
    Panel::new("3D", "bearing", title, settings)
}

/// The log.
pub(super) fn log() -> Panel {
    let settings = json!({ "searchTerms": [], "minLogLevel": 1, "topicToRender": "/log", "nameFilter": {} });
    Panel::new("RosOut", "log", "Events", settings)
}

/// All numbers of the latest message.
pub(super) fn numbers() -> Panel {
    let settings = json!({
        "topicPath": "/bearing/state",
        "diffEnabled": false,
        "diffMethod": "custom",
        "diffTopicPath": "",
        "showFullMessageForDiff": false,
        "fontSize": 11,
    });
    Panel::new("RawMessages", "state", "State, all numbers", settings)
}

/// All numbers of all balls.
pub(super) fn table() -> Panel {
    Panel::new("Table", "balls", "Balls, all numbers", json!({ "topicPath": "/bearing/balls.balls" }))
}

/// The next of 1, 1.5, 2, 2.5, 3, 4, 5, 6 and 8 times a power of ten.
pub(crate) fn round_up(value: f64) -> f64 {
    const STEPS: [f64; 10] = [1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];
    if !(value > 0.0 && value.is_finite()) {
        return value;
    }
    let exponent = value.log10().floor() as i32;
    let mantissa = value / 10_f64.powi(exponent);
    let step = STEPS.into_iter().find(|step| *step >= mantissa * (1.0 - 1e-9)).unwrap_or(10.0);
    // A quotient keeps round numbers below one round.
    if exponent < 0 { step / 10_f64.powi(-exponent) } else { step * 10_f64.powi(exponent) }
}

#[cfg(test)]
mod tests {
    use super::round_up;

    #[test]
    fn limit_scales_end_at_round_numbers() {
        let pairs =
            [(15_405.0, 20_000.0), (2.45, 2.5), (2.5, 2.5), (0.31, 0.4), (9.9, 10.0), (1.0, 1.0), (0.002, 0.002)];
        for (value, expected) in pairs {
            assert_eq!(round_up(value), expected, "{value}");
        }
        assert_eq!(round_up(0.0), 0.0);
    }
}
