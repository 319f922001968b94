//! A beam on a turning base: T. R. Kane's theory in its continuous form, and what the tip does.
//!
//! ```text
//! ρA (ẅ − ω²w + ω̇x) + EI w⁗ − (½ρAω²(L² − x²) w′)′ = 0
//! ```

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector, Vector3};

use super::beams::{Cantilever, ENDS};

/// The beam of Kane, Ryan, Banerjee 1987: m, m², m⁴, Pa, kg/m³.
pub const LENGTH: f64 = 10.0;
pub const AREA: f64 = 4e-4;
pub const SECOND_MOMENT: f64 = 2e-7;
pub const YOUNG: f64 = 7e10;
pub const DENSITY: f64 = 3000.0;

/// The base turns ever faster until then, s.
pub const SPIN_UP: f64 = 15.0;

/// Rates of the base before and after, rad/s.
#[derive(Clone, Copy)]
pub struct Base {
    pub from: f64,
    pub to: f64,
}

/// Kane's.
pub const FROM_REST: Base = Base { from: 0.0, to: 6.0 };

/// A gentle one, in which the beam is taut all the time.
pub const TAUT: Base = Base { from: 5.97, to: 6.0 };

impl Base {
    /// ω and ω̇ at a time.
    pub fn turns(self, time: f64) -> (f64, f64) {
        if time >= SPIN_UP {
            return (self.to, 0.0);
        }
        let (sin, cos) = libm::sincos(TAU * time / SPIN_UP);
        let mean = (self.to - self.from) / SPIN_UP;
        (self.from + mean * (time - SPIN_UP / TAU * sin), mean * (1.0 - cos))
    }
}

/// What the tip does.
pub struct History {
    /// Largest lag, m; infinite when the beam breaks away.
    pub peak_lag: f64,
    /// When, s.
    pub peak_time: f64,
    /// Largest lateral motion in the last two seconds, m.
    pub residual: f64,
    /// Mean stretch in the last two seconds, m.
    pub stretch: f64,
}

/// Runge–Kutta steps of q̈ = f(t, q, q̇) from rest at q over 20 s; `tip` is its lag and stretch at q.
pub fn integrate(
    mut q: DVector<f64>,
    step: f64,
    mut accelerate: impl FnMut(f64, &DVector<f64>, &DVector<f64>) -> DVector<f64>,
    tip: impl Fn(&DVector<f64>) -> [f64; 2],
) -> History {
    let mut p = DVector::zeros(q.len());
    let mut history = History { peak_lag: 0.0, peak_time: 0.0, residual: 0.0, stretch: 0.0 };
    let steps = (20.0 / step).round() as usize;
    let last = (18.0 / step).round() as usize;
    for index in 0..steps {
        let (t, end) = (index as f64 * step, (index + 1) as f64 * step);
        let a1 = accelerate(t, &q, &p);
        let (q2, p2) = (&q + &p * (0.5 * step), &p + &a1 * (0.5 * step));
        let a2 = accelerate(t + 0.5 * step, &q2, &p2);
        let (q3, p3) = (&q + &p2 * (0.5 * step), &p + &a2 * (0.5 * step));
        let a3 = accelerate(t + 0.5 * step, &q3, &p3);
        let (q4, p4) = (&q + &p3 * step, &p + &a3 * step);
        let a4 = accelerate(t + step, &q4, &p4);
        q += (&p + p2 * 2.0 + p3 * 2.0 + p4) * (step / 6.0);
        p += (a1 + a2 * 2.0 + a3 * 2.0 + a4) * (step / 6.0);
        let [lag, stretch] = tip(&q);
        if lag.is_nan() || lag.abs() >= LENGTH {
            history.peak_lag = f64::INFINITY;
            history.peak_time = end;
            return history;
        }
        if lag > history.peak_lag {
            (history.peak_lag, history.peak_time) = (lag, end);
        }
        if index >= last {
            history.residual = history.residual.max(lag.abs());
            history.stretch += stretch / (steps - last) as f64;
        }
    }
    history
}

/// The beam along x, turning about z, its bending out of the plane so many times stiffer than in it.
pub fn beam(out_of_plane: f64) -> Cantilever {
    Cantilever {
        axis: Vector3::x(),
        y_axis: Vector3::y(),
        length: LENGTH,
        axial: YOUNG * AREA,
        torsional: 1e4,
        bending_y: out_of_plane * YOUNG * SECOND_MOMENT,
        bending_z: YOUNG * SECOND_MOMENT,
        mass_per_length: DENSITY * AREA,
        gyration: libm::sqrt(2.0 * SECOND_MOMENT / AREA),
        lumps: ENDS,
    }
}

/// Kane's theory by Galerkin's method in four cantilever modes, integrals by the midpoint rule.
pub struct Kane {
    mass: DMatrix<f64>,
    bending: DMatrix<f64>,
    /// Of the centrifugal force at 1 rad/s.
    tension: DMatrix<f64>,
    lever: DVector<f64>,
    tips: Vec<f64>,
}

pub fn kane() -> Kane {
    let modes = 4;
    const ROOTS: [f64; 4] =
        [1.875_104_068_711_961, 4.694_091_132_974_175, 7.854_757_438_237_613, 10.995_540_734_875_467];
    const PANELS: usize = 2000;
    let line_density = DENSITY * AREA;
    let (mut mass, mut bending, mut tension) =
        (DMatrix::zeros(modes, modes), DMatrix::zeros(modes, modes), DMatrix::zeros(modes, modes));
    let mut lever = DVector::zeros(modes);
    let shape = |k: usize, x: f64| {
        let z = ROOTS[k] * x / LENGTH;
        let (ch, sh, c, s) = (libm::cosh(z), libm::sinh(z), libm::cos(z), libm::sin(z));
        let r = ROOTS[k];
        let sigma = (libm::sinh(r) - libm::sin(r)) / (libm::cosh(r) + libm::cos(r));
        let wave = r / LENGTH;
        [
            ch - c - sigma * (sh - s),
            wave * (sh + s - sigma * (ch - c)),
            wave * wave * (ch + c - sigma * (sh + s)),
        ]
    };
    for panel in 0..PANELS {
        let dx = LENGTH / PANELS as f64;
        let x = (panel as f64 + 0.5) * dx;
        let values: Vec<_> = (0..modes).map(|k| shape(k, x)).collect();
        for (a, [w_a, slope_a, curvature_a]) in values.iter().enumerate() {
            lever[a] += line_density * x * w_a * dx;
            for (b, [w_b, slope_b, curvature_b]) in values.iter().enumerate() {
                mass[(a, b)] += line_density * w_a * w_b * dx;
                bending[(a, b)] += YOUNG * SECOND_MOMENT * curvature_a * curvature_b * dx;
                tension[(a, b)] += 0.5 * line_density * (LENGTH * LENGTH - x * x) * slope_a * slope_b * dx;
            }
        }
    }
    let tips = (0..modes).map(|k| shape(k, LENGTH)[0]).collect();
    Kane { mass, bending, tension, lever, tips }
}

impl Kane {
    /// Lateral stiffness at a steady rate of the base.
    fn stiffness(&self, rate: f64) -> DMatrix<f64> {
        &self.bending + (&self.tension - &self.mass) * (rate * rate)
    }

    pub fn spin_up(&self, base: Base) -> History {
        let inverse = self.mass.clone().try_inverse().unwrap();
        let accelerate = |time: f64, q: &DVector<f64>, _: &DVector<f64>| {
            let (rate, rate_change) = base.turns(time);
            &inverse * (&self.lever * -rate_change - self.stiffness(rate) * q)
        };
        let lag = |q: &DVector<f64>| -q.iter().zip(&self.tips).map(|(q, tip)| q * tip).sum::<f64>();
        integrate(DVector::zeros(self.tips.len()), 1e-3, accelerate, |q| [lag(q), 0.0])
    }

    /// The lowest frequency of lateral motion in the rotating frame, rad/s.
    pub fn frequency(&self, rate: f64) -> f64 {
        let inverse = self.mass.clone().try_inverse().unwrap();
        let squares = (inverse * self.stiffness(rate)).complex_eigenvalues();
        libm::sqrt(squares.iter().map(|square| square.re).fold(f64::INFINITY, f64::min))
    }
}
