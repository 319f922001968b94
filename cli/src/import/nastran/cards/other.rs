//! Cards that say what is computed, not what flies: they are listed and change nothing.

/// Of analyses, loads, output, optimisation.
const OF_ANALYSES: [&str; 78] = [
    "AECOMP", "AEPARM", "AESTAT", "ASET", "ASET1", "AUTOSPC", "CSSCHD", "DAREA", "DCONADD", "DCONSTR",
    "DESVAR", "DIVERG", "DLINK", "DLOAD", "DOPTPRM", "DRESP1", "DRESP2", "DVCREL1", "DVMREL1", "DVPREL1",
    "DVPREL2", "ECHOOFF", "ECHOON", "EIGC", "EIGP", "EIGR", "EIGRL", "FLFACT", "FLUTTER", "FORCE", "FORCE1",
    "FREQ", "FREQ1", "FREQ2", "FREQ3", "FREQ4", "GRAV", "GUST", "LOAD", "MKAERO1", "MKAERO2", "MOMENT",
    "MOMENT1", "MONDSP1", "MONPNT1", "MONPNT2", "NLPARM", "OMIT", "OMIT1", "PLOAD1", "PLOAD4", "PLOTEL",
    "QSET1", "RANDPS", "RFORCE", "RLOAD1", "RLOAD2", "SPLOAD", "SPOINT", "TABDMP1", "TABLED1", "TABLED2",
    "TABLED3", "TABLED4", "TABLEM1", "TABRND1", "TABRNDG", "TEMP", "TEMPD", "TEMPRB", "TLOAD1", "TLOAD2",
    "TRIM", "TSTEP", "TSTEPNL", "USET", "USET1", "UXVEC",
];

pub fn is_of_analyses(name: &str) -> bool {
    OF_ANALYSES.contains(&name)
}
