# Written by `make approve` from figures/input/words.hpp.
array outcome_name[7] = ["no_contact","undecided","freed","bouncing","sliding","rolling","stalled"]
array outcome_tint[7] = ["#f7f7f5","#efe0a0","#a2c8e4","#78aad2","#2e5f8c","#cc6c24","#333333"]
array outcome_words[7] = ["no contact","undecided","freed","bouncing","sliding","rolling","stalled, or no result"]
outcome_palette = "set palette maxcolors 7 defined (0 '#f7f7f5', 1 '#efe0a0', 2 '#a2c8e4', 3 '#78aad2', 4 '#2e5f8c', 5 '#cc6c24', 6 '#333333'); set cbrange [-0.5:6.5]"
words_of(set) = set eq "published" ? "equations as printed" : "corrected equations"
short_of(set) = set eq "published" ? "as printed" : "corrected"
tint_of(set) = set eq "published" ? "#0072b2" : "#b34700"
