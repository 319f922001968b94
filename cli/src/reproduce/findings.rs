//! What the comparison shows for the shipped jet, in words. The numbers are of the flights with its file;
//! what changes with the file (ranges, counts, table) is computed and not written here.

use flexible_aircraft::simulation::Fidelity;

use super::cases::Case;
use super::figures::Comparison;

/// What the page is.
pub const INTRODUCTION: &str = "B. C. B. Tse, <cite>Effects of Inertial and Geometric Nonlinearities in \
    the Simulation of Flexible Aircraft Dynamics</cite> (MASc thesis, University of Toronto, 2013) flies a \
    flexible business jet with five models: E (exact), CL (consistently linearised), I (inconsistent), RL \
    (ruthlessly linearised) and Rigid. Here are the same flights with this program, figure by figure, and \
    Table 5.1.";

/// What the windows tell.
pub const HOW_TO_READ: &str = "The plain field is the window of the thesis' axis, from its printed tick \
    labels; shaded is what we had to add to show our curves. The thesis gives no numbers of its curves, \
    but its axes are Matlab's: the narrowest range from tick to tick that holds all curves. So a figure of \
    ours can do three things: get the same axis (both extremes within one tick of the thesis'), lie inside \
    but fill less, or leave the window.";

/// The result.
pub const IN_SHORT: &str = "In short, for the shipped jet: the wing's deflections in trim agree to 4 %, \
    the rigid-body motions have the thesis' size, and the exact model is the stiffest one, as in the \
    thesis. Three things do not agree: at a tenth of the stiffness our CL, I and RL are trimmed at more \
    pitch than the thesis', with the input that we chose our jet answers the elevator about 1.4 times as \
    strongly, and at 177.8 m/s it is farther from flutter, so that the large structural oscillations of \
    the thesis are absent. The equations are verified separately; the jet's data are a reconstruction, \
    because the thesis' data are not public, and amplitude and timing of the inputs are ours.";

/// Under both inputs.
pub const INPUT: &str = "About the trim. Window of the thesis −0.05 to 0.05 rad and 0 to 15 s.";

/// What is known of the inputs, and what accelerations are.
pub const INPUTS: &str = "The thesis describes a 2-3-1-1 of the elevator through 1/(0.05 s + 1), and its \
    figures give only the ranges of the axes. The amplitude of 0.05 rad, the unit time of 0.7 s, the start \
    at 1 s, the first pulse nose-up, and the rudder doublet (0.05 rad, 2 s each way, first nose right, \
    same filter) are our choice. Figure 5.33 is captioned as the elevator's and is the rudder's. \
    Accelerations are the rates of change of the body-axis velocity components: the inertial accelerations \
    would fill an eighth of the window of figure 5.44.";

/// On Table 5.1.
pub const TABLE: &str = "The jet was fitted to the wing tip's deflections, so their agreement shows that \
    one set of data serves all models; it is no prediction. The tail's do not agree: the thesis has the \
    same deflection in E, CL and I and half of it in RL, ours is smallest in E. In the last column of each \
    tip is what two programs written independently of this one found for the same file: it checks this \
    program and not the data.";

/// On the table of all windows.
pub const WINDOWS: &str = "The lowest and highest value of all curves of a figure, and the share of the \
    window that they fill. Percentages of leaving are of the window's width; the curves that leave are \
    named.";

/// The finding on a group of figures.
pub fn of(comparison: Comparison) -> &'static str {
    match comparison {
        Comparison::Models(Case::ElevatorNominal) => {
            "As in the thesis the models can hardly be told apart: CL, I and RL stay within 2 % of E's \
             range, Rigid within 4 %. All five leave most windows together, by up to 36 % of the width, \
             and mostly downwards in V<sub>z</sub> and ω<sub>y</sub>: the input is too strong for these \
             windows, not the flexibility wrong. With 0.7 times the amplitude figures 5.4, 5.6 and 5.7 \
             would get the thesis' own axes. Since figure 5.1 speaks for 0.05 rad, the thesis' jet has the \
             weaker elevator, or other pulses than ours. With 0.05 rad and the first pulse nose-down \
             figures 5.3 and 5.4 would leave their windows upwards instead. The thesis' pitch goes above \
             0.16 rad and ours does not, which the unknown timing may explain."
        }
        Comparison::Models(Case::ElevatorTenth) => {
            "E and Rigid stay inside all six windows. CL, I and RL leave those that depend on the trim \
             (5.8, 5.9, 5.11, 5.12): they are trimmed at 0.158 to 0.159 rad, Rigid at 0.138, E at 0.136. \
             As in the thesis the curves are offset by their trims; but the thesis' windows for \
             V<sub>z</sub> and θ leave no room for an offset that far upwards. Its wing seems to gain lift \
             by deforming where that of the reconstruction loses lift. CL's growing mode (0.30 ± 33.8i \
             1/s) becomes visible in figure 5.13 towards the end, 3 m/s² from peak to peak; it is a \
             property of an energy that stops at third order."
        }
        Comparison::Models(Case::ElevatorTenthFast) => {
            "As in the thesis E deflects least and is damped best; of the others, CL oscillates longest. \
             The wing tip moves between 2.4 and 6.0 m (window 2 to 8), pitch and speed have the thesis' \
             size. But the structural oscillation is much smaller: ω<sub>y</sub> stays within ±0.04 rad/s \
             where the thesis goes beyond −0.1 and 0.05, a<sub>z</sub> within ±8 m/s² where it goes beyond \
             ±10. The thesis' jet is near flutter at this speed; the reconstruction, fitted to static \
             deflections, is not."
        }
        Comparison::Models(Case::RudderTenth) => {
            "Yaw, yaw rate, roll rate and sideslip have the thesis' size, and two figures would get its \
             axes. Everything that depends on the trim leaves its window: with these 12 modes, six of them \
             symmetric, E is trimmed at 0.159 rad, the linear models at 0.172 to 0.173, Rigid at 0.138, \
             and the thesis shows 0.12 to 0.145 (5.34, 5.36, 5.41). Some of its flexible trims must lie \
             near 0.12 rad, below the rigid one. The flexible models roll two to three times as far as the \
             thesis' (0.08 to 0.11 rad, window to 0.04), while Rigid stays inside: bent wings have \
             dihedral, and ours turns more sideslip into roll."
        }
        Comparison::Models(Case::RudderTenthFast) => {
            "Here we differ most. The thesis shows structural oscillations that dominate everything \
             (a<sub>y</sub> to more than 20 m/s², a loss of speed of more than 7 m/s); ours are damped and \
             fill less than a sixth of those windows. The forward speed varies by 0.2 m/s. The lateral \
             motion itself (roll rate −0.21 to 0.15 rad/s) is of the thesis' size, and roll leaves its \
             window upwards for the reason given above. The cause is the distance to flutter: the thesis' \
             approximate models are at or beyond it at this speed; of ours only CL grows, and slowly."
        }
        Comparison::Aerodynamics(Fidelity::ConsistentlyLinearised) => {
            "The thesis finds a larger effect in CL than in E, because CL oscillates more. Ours is larger \
             too, but hardly: up to 6 % of the range. CL's trim is 0.013 rad above E's, which takes \
             V<sub>x</sub>, V<sub>z</sub> and θ out of their windows by up to 36 % of the width."
        }
        Comparison::Aerodynamics(_) => {
            "As in the thesis, unsteady and steady aerodynamics give very similar motions with the exact \
             model: they differ by at most 5 % of the range of each quantity. Our E goes on accelerating \
             after the manoeuvre, to 178.5 m/s, and leaves the window of figure 5.21; the thesis' stays \
             below 177.8 m/s."
        }
    }
}
