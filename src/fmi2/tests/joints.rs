//! An aircraft whose joints close loops: its FMU flies, and refuses by name the one level that has none.

use super::*;
use crate::aircraft::Aircraft;
use crate::structure::ReducedModel;

#[test]
fn an_fmu_with_a_loop_refuses_the_geometrically_exact_level_and_flies_the_others() {
    let text = include_str!("../../../tests/data/strut-braced.toml");
    let model = ReducedModel::new(&Aircraft::parse(text, "strut-braced.toml").unwrap(), 6).unwrap();
    let (unpacked, guid) = (Unpacked::of(&model.to_bytes(), "wing"), guid(&model));
    let reference = VariableTable::new(&model).reference("model").unwrap();
    let entered = |level: c_int| {
        let fmu = endurance::wing(&unpacked, &guid);
        assert!(!fmu.component.is_null(), "{:?}", fmu.log);
        // SAFETY: the component is alive, the arrays have one element.
        assert_eq!(unsafe { fmi2SetInteger(fmu.component, &reference, 1, &level) }, Status::Ok);
        let statuses = [fmu.set_up(None, 0.0, None), fmu.enter(), fmu.exit()];
        (fmu, statuses)
    };
    for level in 1..=5 {
        let (fmu, statuses) = entered(level);
        assert_eq!(statuses, [Status::Ok; 3], "{level}: {:?}", fmu.log);
        assert_eq!(fmu.step(0.0, 0.02), Status::Ok);
    }
    let (fmu, statuses) = entered(6);
    assert!(statuses.contains(&Status::Error), "{statuses:?}");
    fmu.assert_refused(&[
        "model: found geometrically_exact",
        "the joint of \"strut_right\" at 1 and \"wing_right\" at 0.5",
    ]);
}
