//! Cards that say what is computed, not what flies: they are listed and change nothing.

/// Of analyses, loads, output, optimisation.
const OF_ANALYSES: [&str; 58] = [
    "AECOMP", "AELINK", "AEPARM", "AESTAT", "ASET", "ASET1", "AUTOSPC", "CSSCHD", "DAREA", "DCONSTR",
    "DESVAR", "DLOAD", "DRESP1", "DRESP2", "DVPREL1", "EIGC", "EIGR", "EIGRL", "FLFACT", "FLUTTER", "FORCE",
    "FORCE1", "FREQ", "FREQ1", "FREQ2", "FREQ3", "FREQ4", "GRAV", "GUST", "LOAD", "MKAERO1", "MKAERO2",
    "MOMENT", "MOMENT1", "MONDSP1", "MONPNT1", "MONPNT2", "NLPARM", "OMIT", "OMIT1", "PAERO1", "PLOAD1",
    "PLOTEL", "QSET1", "RANDPS", "RLOAD1", "RLOAD2", "SPLOAD", "SPOINT", "SUPORT1", "TABDMP1", "TABLED1",
    "TABRND1", "TABRNDG", "TLOAD1", "TRIM", "TSTEP", "UXVEC",
];

/// Parameters that change the masses or stiffness of the model, with what they would do; WTMASS is read.
const PARAMETERS_OF_THE_MODEL: [(&str, &str); 5] = [
    ("COUPMASS", "masses of elements are at two places in each, which have its mass, centre and inertia"),
    ("K6ROT", "there are no shells"),
    ("SNORM", "there are no shells"),
    ("AUTOSPC", "components without stiffness are never in the equations here"),
    ("GRDPNT", "masses are told in the report"),
];

pub fn is_of_analyses(name: &str) -> bool {
    OF_ANALYSES.contains(&name)
}

/// What a parameter of the model would do, if it is one.
pub fn parameter(name: &str) -> Option<&'static str> {
    PARAMETERS_OF_THE_MODEL.iter().find(|(parameter, _)| *parameter == name).map(|(_, said)| *said)
}
