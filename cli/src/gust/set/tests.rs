//! Sets of gusts as they are asked for.

use clap::Parser;
use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::structure::ReducedModel;

use super::*;

#[derive(Parser)]
struct Line {
    #[command(flatten)]
    gusts: GustSetOptions,
}

fn settings() -> Settings {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data/small-aircraft.toml");
    Settings::of(&ReducedModel::new(&Aircraft::read(&path).unwrap(), 2).unwrap())
}

fn options(line: &str) -> GustSetOptions {
    Line::parse_from(std::iter::once("gust").chain(line.split_whitespace())).gusts
}

fn cases(line: &str) -> Vec<Case> {
    options(line).cases(&settings(), &[], 10.0).unwrap()
}

fn names(line: &str) -> Vec<String> {
    cases(line).iter().map(Case::name).collect()
}

#[test]
fn every_gradient_is_flown_in_every_direction_and_against_it_once() {
    assert_eq!(cases("").len(), 74);
    assert_eq!(
        names("--gradients 20,30"),
        ["gust 20 m up", "gust 30 m up", "gust 20 m down", "gust 30 m down"]
    );
    assert_eq!(names("--gradients 30,30 --direction -90,90"), ["gust 30 m left", "gust 30 m right"]);
    assert_eq!(names("--gradients 30 --direction 0 --direction 90").len(), 4);
    // With an inclination a gust to the right and one against that to the left differ.
    let mut inclined = settings();
    inclined.gust.inclination = 0.2;
    assert_eq!(options("--gradients 30 --direction -90,90").cases(&inclined, &[], 10.0).unwrap().len(), 4);
}

#[test]
fn the_peak_is_given_or_follows_from_a_criterion_with_its_alleviation() {
    let gust = |line: &str| cases(line)[0].gust;
    assert_eq!(gust("").criterion, GustCriterion::Cs25Vc);
    assert_eq!(gust("--criterion cs25_vd").criterion, GustCriterion::Cs25Vd);
    let given = gust("--peak 3 --gradients 200");
    assert_eq!((given.criterion, given.peak, given.gradient), (GustCriterion::Peak, 3.0, 200.0));
    assert!((gust("--weights 10,10,10").alleviation - (1.0 - 0.5 * 12_500.0 / 76_200.0)).abs() < 1e-12);
}

#[test]
fn what_an_option_says_is_not_overridden_in_silence() {
    let refused = |line: &str, set: &str| options(line).cases(&settings(), &[set.to_owned()], 10.0);
    for (line, set, instead) in [
        ("", "gust.peak=3", "--peak"),
        ("", "gust.shape=none", "--gradients"),
        ("--peak 3", "gust.direction=1", "--direction"),
        ("--weights 3,2,1", "gust.alleviation=0.5", "--weights"),
    ] {
        assert_eq!(refused(line, set), Err(Error::OwnParameter(set.to_owned(), instead)));
    }
    assert!(refused("", "gust.alleviation=0.5").is_ok() && refused("", "gust.start=2").is_ok());
    for line in ["--peak 3 --weights 3,2,1", "--peak 3 --criterion cs25_vd"] {
        let line = std::iter::once("gust").chain(line.split_whitespace());
        assert!(Line::try_parse_from(line).err().unwrap().to_string().contains("cannot be used with"));
    }
}

#[test]
fn gusts_that_cs25_does_not_know_or_nobody_meets_are_refused() {
    let refused = |line: &str, duration: f64| options(line).cases(&settings(), &[], duration).unwrap_err();
    assert_eq!(refused("--gradients 30,5", 10.0), Error::Cs25Gradient(5.0));
    assert_eq!(refused("", 1.0), Error::Late { duration: 1.0, start: 1.0 });
}

#[test]
fn a_gust_that_is_not_over_at_the_end_is_told() {
    let settings = settings();
    let end = 1.0 + 2.0 * 60.0 / settings.plant.airspeed;
    let told = |duration| cut_off(&cases("--gradients 30,60"), &settings, duration);
    assert_eq!(told(end + 1e-9), None);
    assert!(told(end - 1e-9).unwrap().contains("a gradient of 60 m, met at 1 s"));
}
