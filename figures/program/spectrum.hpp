/// Amplitudes of circular motions in a plane.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "model/mechanics/parameters.hpp"

namespace rotor {

/// Amplitudes of a plane vector x + iy that is sampled at N equal intervals of a time T: of n
/// turns in T at n, against x to y at N - n. A steady circle has its radius at its nearest n, to
/// 0.05 % at any frequency; n that are 5 or more away from its frequency have less than 1e-4 of
/// it. The window is HFT90D of Heinzel, Rüdiger and Schilling (2002), Spectrum and spectral
/// density estimation by the DFT.
inline std::vector<double> amplitudes(std::vector<std::complex<double>> signal) {
  constexpr std::array window = {1., -1.942604, 1.340318, -0.440811, 0.043097};
  const auto count = static_cast<double>(signal.size());
  for (std::size_t k = 0; k < signal.size(); ++k) {
    double weight = 0;
    for (std::size_t i = 0; i < window.size(); ++i)
      weight += window[i] * std::cos(two_pi * static_cast<double>(i * k) / count);
    signal[k] *= weight / count;
  }
  std::vector<std::complex<double>> transformed;
  Eigen::FFT<double>().fwd(transformed, signal);
  std::vector<double> all;
  for (const std::complex<double>& value : transformed) all.push_back(std::abs(value));
  return all;
}

}  // namespace rotor
