// Written by `make approve` from figures/input/words.hpp.
export const outcomes = {
 "no_contact": "does not touch the ring up to the end of the run",
 "undecided": "has not touched the ring so far, but contact is possible",
 "freed": "has touched the ring, and cannot reach it again at its speed",
 "bouncing": "bounces, and further contacts are possible",
 "sliding": "slides along the ring",
 "rolling": "has come to roll along the ring",
 "stalled": "is below 1.5 times its critical speed and gains less than a tenth of what its motor would add"
};
export const results = {
 "speed_at_mass_loss_Hz": "speed at the mass loss",
 "speed_ratio_at_mass_loss": "speed over the critical speed",
 "touch_downs": "touch-downs",
 "first_contact_s": "first contact",
 "rolling_onset_s": "onset of rolling",
 "rolling_onset_speed_Hz": "speed at the onset of rolling",
 "rolling_onset_force_N": "force at the onset of rolling",
 "peak_normal_force_N": "largest normal force",
 "peak_time_s": "time of the largest force",
 "peak_displacement_m": "largest displacement",
 "contact_time_s": "time in contact",
 "peak_bearing_force_N": "bearing force without weight",
 "whirl_frequency_Hz": "mean whirl in the last rolling",
 "rolling_until_s": "end of rolling",
 "final_time_s": "end of the run",
 "final_speed_Hz": "speed at the end"
};
export const lines = [{"width":2.0,"dashes":[],"words":"closed forms: border of contact"},{"width":1.6,"dashes":[5,4],"words":"upper bound of the swing reaches the ring"},{"width":1.6,"dashes":[1,4],"words":"steady response reaches the ring"},{"width":1.6,"dashes":[14,4],"words":"friction up to which forward rub lasts"},{"width":1.6,"dashes":[10,4,2,4],"words":"friction from which rebounds lead to backward whirl"},{"width":1.6,"dashes":[14,4,2,4,2,4],"words":"largest force of 300 kN"}];
