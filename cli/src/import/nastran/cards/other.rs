//! Cards that say what is computed, not what flies: they are listed and change nothing.

/// Of analyses, loads, output, optimisation.
const OF_ANALYSES: [&str; 56] = [
    "AECOMP", "AEPARM", "AESTAT", "ASET", "ASET1", "AUTOSPC", "CSSCHD", "DAREA", "DCONSTR", "DESVAR",
    "DLOAD", "DRESP1", "DRESP2", "DVPREL1", "EIGC", "EIGR", "EIGRL", "FLFACT", "FLUTTER", "FORCE", "FORCE1",
    "FREQ", "FREQ1", "FREQ2", "FREQ3", "FREQ4", "GRAV", "GUST", "LOAD", "MKAERO1", "MKAERO2", "MOMENT",
    "MOMENT1", "MONDSP1", "MONPNT1", "MONPNT2", "NLPARM", "OMIT", "OMIT1", "PLOAD1", "PLOTEL", "QSET1",
    "RANDPS", "RLOAD1", "RLOAD2", "SPLOAD", "SPOINT", "SUPORT1", "TABDMP1", "TABLED1", "TABRND1", "TABRNDG",
    "TLOAD1", "TRIM", "TSTEP", "UXVEC",
];

pub fn is_of_analyses(name: &str) -> bool {
    OF_ANALYSES.contains(&name)
}
