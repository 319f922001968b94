//! What Parquet reads back of a part.

use parquet::record::RowAccessor;

use super::*;

fn column(name: &str, unit: &str) -> Column {
    Column { name: name.to_owned(), unit: unit.to_owned() }
}

fn rows() -> Vec<Row> {
    let outcomes = [
        Ok(Success { numbers: vec![Some(1.5), None], warning: String::new() }),
        Err(Failure { status: Status::NoTrim, message: "no trim, ä".to_owned() }),
        Ok(Success { numbers: vec![Some(-0.0), Some(1e300)], warning: "beyond".to_owned() }),
    ];
    let row = |(point, outcome)| Row { point, varied: vec![100.0 + point as f64, 0.1], outcome };
    (3..).zip(outcomes).map(row).collect()
}

fn format() -> Format {
    let varied = [column("airspeed", "m/s"), column("component.wing.stiffness", "1")];
    let kept = [column("load_factor.z.max", "1"), column("loads.root.bending.time_of_max", "s")];
    Format::new(&varied, &kept).unwrap()
}

/// Writes bytes to a file of a folder.
fn written(bytes: &[u8]) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("part-00000.parquet");
    std::fs::write(&path, bytes).unwrap();
    (folder, path)
}

#[test]
fn a_part_is_read_back_as_it_was_with_nothing_where_there_was_nothing() {
    let (_folder, path) = written(&format().bytes(&rows()).unwrap());
    let reader = SerializedFileReader::new(File::open(&path).unwrap()).unwrap();
    let metadata = reader.metadata().file_metadata();
    let names: Vec<&str> = metadata.schema_descr().columns().iter().map(|column| column.name()).collect();
    let expected = ["point", "airspeed", "component.wing.stiffness", "status", "message"];
    assert_eq!(names[..5], expected);
    assert_eq!(names[5..], ["load_factor.z.max", "loads.root.bending.time_of_max"]);
    let units = metadata.key_value_metadata().unwrap().iter().find(|pair| pair.key == "units").unwrap();
    let units: Value = serde_json::from_str(units.value.as_ref().unwrap()).unwrap();
    assert_eq!(
        (units["airspeed"].as_str(), units["loads.root.bending.time_of_max"].as_str()),
        (Some("m/s"), Some("s"))
    );
    let read: Vec<parquet::record::Row> = reader.get_row_iter(None).unwrap().map(Result::unwrap).collect();
    assert_eq!(read.len(), 3);
    for (read, row) in read.iter().zip(rows()) {
        assert_eq!(
            (read.get_long(0).unwrap(), read.get_double(1).unwrap()),
            (row.point as i64, row.varied[0])
        );
        assert_eq!(read.get_string(3).unwrap(), row.status().name());
        assert_eq!(read.get_string(4).unwrap(), row.message());
        for kept in 0..2 {
            let found = read.get_double(5 + kept).ok().map(f64::to_bits);
            assert_eq!(found, row.kept(kept).map(f64::to_bits));
        }
    }
}

#[test]
fn a_part_is_counted_by_how_points_came_out_and_one_that_is_not_whole_is_refused() {
    let bytes = format().bytes(&rows()).unwrap();
    let (_folder, path) = written(&bytes);
    let found = Outcomes::read(&path, &(3..6)).unwrap();
    assert_eq!(
        (found.tally, found.first_failure.clone()),
        ([2, 1, 0, 0], Some((4, "no trim, ä".to_owned())))
    );
    assert_eq!(found, Outcomes::of(&rows()));
    let mut all = Outcomes { tally: [0, 0, 0, 1], first_failure: Some((1000, "invalid".to_owned())) };
    all.add(found.clone());
    assert_eq!((all.tally, all.first_failure), ([2, 1, 0, 1], found.first_failure));
    let other = Outcomes::read(&path, &(0..4)).unwrap_err().to_string();
    assert!(other.contains("found 3 points, expected 4; delete it"), "{other}");
    for broken in [&bytes[..bytes.len() - 10], b"", b"PAR1"] {
        let (_folder, path) = written(broken);
        let refused = Outcomes::read(&path, &(3..6)).unwrap_err().to_string();
        assert!(refused.contains("part-00000.parquet: ") && refused.contains("delete it"), "{refused}");
    }
}

#[test]
fn the_same_rows_are_the_same_bytes() {
    assert_eq!(format().bytes(&rows()).unwrap(), format().bytes(&rows()).unwrap());
}
