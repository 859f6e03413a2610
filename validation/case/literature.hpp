/// Citations of publications that several cases come from.
#pragma once

#include <string>

namespace seiche::validation::literature {

inline const std::string frank = "A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994)";
inline const std::string bogomolov =
    "Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method";
inline const std::string synolakis = "C. E. Synolakis, The runup of solitary waves, J. Fluid Mech. 185 (1987) 523";
inline const std::string su_mirie = "C. H. Su, R. M. Mirie, J. Fluid Mech. 98 (1980) 509";
inline const std::string martin_moyce = "J. C. Martin, W. J. Moyce, Phil. Trans. R. Soc. Lond. A 244 (1952) 312";
inline const std::string hall_watts = "J. V. Hall, G. M. Watts, Beach Erosion Board Tech. Memo. 33 (1953)";
inline const std::string miles = "J. W. Miles, J. Fluid Mech. 79 (1977) 171";
inline const std::string plunging_sph = "Plunging breaking waves by weakly compressible smoothed particles";
inline const std::string longuet_higgins_cokelet =
    "M. S. Longuet-Higgins, E. D. Cokelet, Proc. R. Soc. Lond. A 350 (1976) 1";
inline const std::string baker_meiron_orszag = "G. R. Baker, D. I. Meiron, S. A. Orszag, J. Fluid Mech. 123 (1982) 477";
inline const std::string dutykh_clamond = "D. Dutykh, D. Clamond, Wave Motion 51 (2014) 86";

}  // namespace seiche::validation::literature
