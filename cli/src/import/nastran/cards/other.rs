//! Cards that say what is computed, not what flies: they are listed and change nothing.

/// Of analyses, loads, output, optimisation.
const OF_ANALYSES: [&str; 113] = [
    "ACCEL", "ACCEL1", "AECOMP", "AEPARM", "AESTAT", "ASET", "ASET1", "AUTOSPC", "BSET", "BSET1", "CBARAO",
    "CSET", "CSET1", "CSSCHD", "DAREA", "DCONADD", "DCONSTR", "DEFORM", "DELAY", "DEQATN", "DESVAR",
    "DIVERG", "DLINK", "DLOAD", "DOPTPRM", "DPHASE", "DRESP1", "DRESP2", "DRESP3", "DSCREEN", "DTABLE",
    "DVCREL1", "DVCREL2", "DVGRID", "DVMREL1", "DVMREL2", "DVPREL1", "DVPREL2", "ECHOOFF", "ECHOON", "EIGB",
    "EIGC", "EIGP", "EIGR", "EIGRL", "FLFACT", "FLUTTER", "FORCE", "FORCE1", "FREQ", "FREQ1", "FREQ2",
    "FREQ3", "FREQ4", "FREQ5", "GRAV", "GUST", "LOAD", "LSEQ", "MDLPRM", "MKAERO1", "MKAERO2", "MOMENT",
    "MOMENT1", "MONDSP1", "MONPNT1", "MONPNT2", "MONPNT3", "MONSUM", "NLPARM", "OMIT", "OMIT1", "PLOAD",
    "PLOAD1", "PLOAD2", "PLOAD4", "PLOTEL", "QSET1", "RANDPS", "RANDT1", "RFORCE", "RLOAD1", "RLOAD2",
    "SEQGP", "SLOAD", "SPCD", "SPLOAD", "SPOINT", "TABDMP1", "TABLED1", "TABLED2", "TABLED3", "TABLED4",
    "TABLEM1", "TABLEM2", "TABLEM3", "TABLEM4", "TABRND1", "TABRNDG", "TEMP", "TEMPD", "TEMPRB", "TIC",
    "TLOAD1", "TLOAD2", "TRIM", "TRIM2", "TSTEP", "TSTEP1", "TSTEPNL", "USET", "USET1", "UXVEC",
];

pub fn is_of_analyses(name: &str) -> bool {
    OF_ANALYSES.contains(&name)
}
