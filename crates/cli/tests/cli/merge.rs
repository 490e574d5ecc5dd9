//! `sweep --merge`: tables of shards as the one table of the whole sweep.

use super::{Scratch, fixture, run};
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

const AXIAL: &str = "ring.z.Force=kN(40..60 in 20)";

fn part(scratch: &Scratch, name: &str, values: &str, shard: &str) -> PathBuf {
    let (case, table) = (fixture("paper-handset.ron"), scratch.0.join(name));
    let words: [&dyn AsRef<OsStr>; 8] = [&"sweep", &case, &"--set", &values, &"--shard", &shard, &"-o", &table];
    run(&words).table();
    table
}

fn merge(tables: &[&Path], output: &Path) -> super::Outcome {
    let mut words: Vec<&dyn AsRef<OsStr>> = vec![&"sweep", &"--merge"];
    words.extend(tables.iter().map(|table| table as &dyn AsRef<OsStr>));
    let rest: [&dyn AsRef<OsStr>; 3] = [&"-o", &output, &"--json"];
    run(&[&words[..], &rest].concat())
}

#[test]
fn identity_shards_put_together_are_the_whole() {
    let scratch = Scratch::new();
    for ending in ["csv", "parquet"] {
        let parts: Vec<PathBuf> =
            (0..3).map(|i| part(&scratch, &format!("part-{i}.{ending}"), AXIAL, &format!("{i}/3"))).collect();
        let whole = part(&scratch, &format!("whole.{ending}"), AXIAL, "0/1");
        let table = scratch.0.join(format!("merged.{ending}"));
        // In any order.
        let answer = merge(&[&parts[2], &parts[0], &parts[1]], &table).json();
        assert_eq!((&answer["rows"], &answer["tables"], &answer["failed_rows"]), (&20.into(), &3.into(), &0.into()));
        assert_eq!(fs::read(&table).unwrap(), fs::read(&whole).unwrap(), "{ending}");
        // What is there stays where the tables do not fit.
        let before = fs::read(&table).unwrap();
        merge(&[&parts[0], &parts[2]], &table).fails(2, &["are in none of the tables"]);
        merge(&[&parts[0], &parts[1], &parts[2], &parts[1]], &table).fails(2, &["part-1", "is there twice"]);
        merge(&[&table, &parts[0]], &table).fails(2, &["would be replaced"]);
        assert_eq!(fs::read(&table).unwrap(), before);
    }
    let other = part(&scratch, "other.parquet", "ring.z.Force=kN(40..61 in 20)", "0/1");
    let table = scratch.0.join("mixed.parquet");
    merge(&[&scratch.0.join("part-0.parquet"), &other], &table).fails(2, &["of another sweep", "swept"]);
    let csv = scratch.0.join("part-0.csv");
    merge(&[&csv, &other], &table).fails(2, &["part-0.csv", "is not of the kind of"]);
    merge(&[&scratch.0.join("absent.parquet")], &table).fails(2, &["cannot read", "absent.parquet"]);
    let text = scratch.file("text.csv", "a,b\n1,2\n");
    merge(&[&text], &scratch.0.join("mixed.csv")).fails(2, &["text.csv", "not a table of a sweep"]);
    assert!(!table.exists() && !scratch.0.join("mixed.csv").exists());
}
