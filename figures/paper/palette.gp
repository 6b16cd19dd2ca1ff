# Written by `make approve` from figures/input/words.hpp.
array outcome_name[8] = ["no_contact","undecided","freed","bouncing","sliding","rolling","stalled",""]
array outcome_tint[8] = ["#f7f7f5","#efe0a0","#a5d4b8","#62b08c","#1f6b52","#bf5b98","#333333","#b0b0b0"]
array outcome_words[8] = ["no contact","undecided","freed","bouncing","sliding","rolling","stalled","no result"]
outcome_palette = "set palette maxcolors 8 defined (0 '#f7f7f5', 1 '#efe0a0', 2 '#a5d4b8', 3 '#62b08c', 4 '#1f6b52', 5 '#bf5b98', 6 '#333333', 7 '#b0b0b0'); set cbrange [-0.5:7.5]"
words_of(set) = set eq "published" ? "equations as printed" : "corrected equations"
short_of(set) = set eq "published" ? "as printed" : "corrected"
tint_of(set) = set eq "published" ? "#0072b2" : "#b34700"
array line_words[6] = ["closed forms: border of contact","upper bound of the swing reaches the ring","steady response reaches the ring","friction up to which forward rub lasts","friction from which rebounds lead to backward whirl","largest force of 300 kN"]
array line_style[6] = ["linewidth 2 dashtype solid","linewidth 1.6 dashtype (5,4)","linewidth 1.6 dashtype (1,4)","linewidth 1.6 dashtype (14,4)","linewidth 1.6 dashtype (10,4,2,4)","linewidth 1.6 dashtype (14,4,2,4,2,4)"]
paper_tint = "#707070"
law_tint = "#7a0177"
event_tint = "#000000"
