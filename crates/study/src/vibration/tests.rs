//! Files of signals in each format, sound and damaged.

use super::{SignalFile, SignalQuestion, Speed, Window, analysis, bearing_of_numbers, diagnosed};
use std::path::{Path, PathBuf};
use tribodyn::Limits;
use tribodyn_signal::Search;

struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("tribodyn-vibration-{}-{name}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        Self(folder)
    }

    fn file(&self, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
        let path = self.0.join(name);
        std::fs::write(&path, content).unwrap();
        path
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn read(path: &Path) -> Result<SignalFile, String> {
    SignalFile::read(path, &Limits::NORMAL).map_err(|error| error.to_string())
}

#[test]
fn limit_text_in_all_its_forms() {
    let scratch = Scratch::new("text");
    for (name, text) in [
        ("a.csv", "time,a\n0,1.5\n0.1,-2e-3\n"),
        ("b.txt", "# rig 7\ntime a\n 0   1.5\n0.1 -2e-3\n"),
        ("c.tsv", "\u{feff}time\ta\r\n0\t1,5\r\n0,1\t-2e-3\r\n"),
        ("d.csv", "\"time\";\"a\"\n0;1,5\n0,1;-2e-3\n"),
    ] {
        let file = read(&scratch.file(name, text)).unwrap();
        assert_eq!(file.column("a").unwrap().values, [1.5, -2e-3], "{name}");
        assert_eq!(file.column("2").unwrap().name, "a", "{name}");
    }
    let plain = read(&scratch.file("e.csv", "1,2\n3,4\n")).unwrap();
    assert_eq!((plain.columns[1].name.as_str(), &plain.columns[1].values[..]), ("2", &[2.0, 4.0][..]));
    for (text, message) in [
        ("a,b\n1,2\n1,NaN\n", ":3:2: `NaN` in column b: allowed is a finite number"),
        ("a,b\n1,2\n1,x\n", ":3:2: `x` in column b: allowed is a finite number"),
        ("a,b\n1,2\n1\n", ":3:2: 1 columns where the first line has 2"),
        ("a,b\n1,2,3\n", ":2:3: column 3 is one more than the first line has"),
        ("a,a\n1,2\n", ":1:2: a second column `a`"),
        ("", ":1:1: the file is empty"),
    ] {
        let error = read(&scratch.file("bad.csv", text)).unwrap_err();
        assert!(error.ends_with(message), "{error}");
    }
    let error = read(&scratch.file("a.xls", "")).unwrap_err();
    assert!(error.contains("allowed is a name that ends in .csv"), "{error}");
}

#[test]
fn identity_sounds_come_back() {
    let scratch = Scratch::new("wav");
    let path = scratch.0.join("a.wav");
    let sample_format = hound::SampleFormat::Int;
    let spec = hound::WavSpec { channels: 2, sample_rate: 48_000, bits_per_sample: 16, sample_format };
    let mut writer = hound::WavWriter::create(&path, spec).unwrap();
    [16_384i16, -32_768, 0, 8192].into_iter().for_each(|sample| writer.write_sample(sample).unwrap());
    writer.finalize().unwrap();
    let file = read(&path).unwrap();
    assert_eq!(file.rate_hz, Some(48_000.0));
    assert_eq!((&file.columns[0].values[..], &file.columns[1].values[..]), (&[0.5, 0.0][..], &[-1.0, 0.25][..]));
    assert!(read(&scratch.file("b.wav", "RIFF")).is_err());
}

/// An element of a MATLAB file of level 5.
fn element(kind: u32, data: &[u8]) -> Vec<u8> {
    let mut bytes = [kind.to_le_bytes(), (data.len() as u32).to_le_bytes()].concat();
    bytes.extend(data);
    bytes.resize(bytes.len().next_multiple_of(8), 0);
    bytes
}

/// An array of a class with its numbers, or the fields of a structure, already in bytes.
fn array(name: &str, class: u8, shape: [u32; 2], content: &[u8]) -> Vec<u8> {
    let flags = [u32::from(class).to_le_bytes(), [0; 4]].concat();
    let shape = shape.map(u32::to_le_bytes).concat();
    element(14, &[element(6, &flags), element(5, &shape), element(1, name.as_bytes()), content.to_vec()].concat())
}

#[test]
fn identity_matlab_arrays_come_back() {
    let scratch = Scratch::new("mat");
    let header = || {
        let mut bytes = vec![b' '; 124];
        bytes.extend([0, 1, b'I', b'M']);
        bytes
    };
    let numbers = [0.5f64, -1.25, 3.0, 7.0].map(f64::to_le_bytes).concat();
    let signal = array("X105_DE_time", 6, [4, 1], &element(9, &numbers));
    // Whole numbers of double precision are stored short, here within the tag.
    let speed = array(
        "X105RPM",
        6,
        [1, 1],
        &[4u16.to_le_bytes(), 2u16.to_le_bytes()].concat().into_iter().chain(*b"\x04\x07\0\0").collect::<Vec<u8>>(),
    );
    let matrix = array("both", 7, [2, 2], &element(7, &[1f32, 2.0, 3.0, 4.0].map(f32::to_le_bytes).concat()));
    let inner = array("", 6, [1, 4], &element(9, &numbers));
    let names = [element(5, &8u32.to_le_bytes()), element(1, b"Data\0\0\0\0")].concat();
    let structure = array("S", 2, [1, 1], &[names, inner].concat());
    let rate = array("rate_hz", 6, [1, 1], &element(9, &25_600f64.to_le_bytes()));
    let plain = [header(), signal.clone(), matrix, structure, rate].concat();
    let file = read(&scratch.file("a.mat", &plain)).unwrap();
    assert_eq!(file.rate_hz, Some(25_600.0));
    assert_eq!(file.column("X105_DE_time").unwrap().values, [0.5, -1.25, 3.0, 7.0]);
    assert_eq!(file.column("both(2)").unwrap().values, [3.0, 4.0]);
    assert_eq!(file.column("S.Data").unwrap().values, [0.5, -1.25, 3.0, 7.0]);
    let short = read(&scratch.file("s.mat", [header(), speed].concat())).unwrap();
    assert_eq!(short.column("X105RPM").unwrap().values, [1796.0]);
    let packed = miniz_oxide::deflate::compress_to_vec_zlib(&signal, 6);
    let mut stream = [15u32.to_le_bytes(), (packed.len() as u32).to_le_bytes()].concat();
    stream.extend(&packed);
    let file = read(&scratch.file("z.mat", [header(), stream].concat())).unwrap();
    assert_eq!(file.columns[0].values, [0.5, -1.25, 3.0, 7.0]);
    let error = read(&scratch.file("cut.mat", &plain[..200])).unwrap_err();
    assert!(error.ends_with("it ends within a variable"), "{error}");
    let error = read(&scratch.file("h.mat", b"MATLAB 7.3 MAT-file")).unwrap_err();
    assert!(error.contains("save -v7"), "{error}");
}

#[test]
fn limit_questions_that_cannot_be_answered_say_what_is_missing() {
    let scratch = Scratch::new("question");
    let rows: String = (0..200).map(|n| format!("{},{},{}\n", f64::from(n) / 2000.0, n % 7, n % 3)).collect();
    let path = scratch.file("a.csv", format!("time,a,b\n{rows}"));
    let file = read(&path).unwrap();
    let bearing = bearing_of_numbers("9,7.94,39.04").unwrap();
    let ask = |channel, rate, window, speed: &Speed| {
        let answer = analysis(&path, &file, (channel, rate), window, speed, (&bearing, None), Search::default());
        answer.unwrap_err().to_string()
    };
    let near = Speed::Near(30.0);
    assert!(ask(None, None, Window::default(), &near).contains("several signals: time (200), a (200), b (200)"));
    assert!(ask(Some("c"), None, Window::default(), &near).contains("no column `c`"));
    // The rate is that of the column of time: 0.1 s are three turns.
    assert!(ask(Some("a"), None, Window::default(), &near).contains("3.0 turns"));
    let late = Window { from_s: Some(3.0), to_s: None };
    assert!(ask(Some("a"), None, late, &near).contains("allowed is 0 to"));
    assert!(ask(Some("a"), Some(-1.0), Window::default(), &near).contains("above 0"));
    let pulses = Speed::KeyPhase("b".to_owned(), 0.0);
    assert!(ask(Some("a"), None, Window::default(), &pulses).contains("pulses"));
    assert_eq!(bearing_of_numbers("9,7.94"), None);
    assert_eq!(bearing_of_numbers("6205"), None);
    assert_eq!(bearing_of_numbers("9,7.94,39.04,15").unwrap().contact_angle_rad, 15f64.to_radians());
}

/// A rate beside that of the file is used, with a warning; numbers that make no bearing are to blame, not the file.
#[test]
fn limit_a_rate_that_is_not_that_of_the_file_is_warned_of() {
    let scratch = Scratch::new("contradiction");
    let rows: String = (0..6000).map(|n| format!("{},{}\n", f64::from(n) / 2000.0, (n * n) % 97)).collect();
    let question = |rate_hz, bearing: &str| SignalQuestion {
        file: scratch.file("a.csv", format!("time,a\n{rows}")),
        channel: None,
        rate_hz,
        bearing: Some(bearing.to_owned()),
        angle_deg: None,
        speed: Some("-1797".to_owned()),
        key_phase: None,
        window: Window::default(),
        speed_tolerance_percent: 1.5,
        slip_percent: 2.0,
    };
    let warnings = |rate| diagnosed(&question(rate, "9,7.94,39.04"), &Limits::NORMAL).unwrap().diagnosis.warnings;
    let said = |rate| warnings(rate).iter().filter(|warning| warning.contains("the file says 2000 Hz")).count();
    assert_eq!((said(Some(4000.0)), said(Some(2000.0)), said(None)), (1, 0, 0));
    let error = diagnosed(&question(None, "9,7.94,7"), &Limits::NORMAL).unwrap_err().to_string();
    assert_eq!(error, "bearing = 9,7.94,7: 9 balls of 7.94 mm on a pitch circle of 7 mm at 0° do not make a bearing");
}
