#pragma once

#include <Eigen/CholmodSupport>
#include <limits>

namespace trajan {

/// Supernodal Cholesky (Chen, Davis, Hager and Rajamanickam 2008).
class Cholesky : public Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>, Eigen::Lower> {
 public:
  Cholesky() { cholmod().print = 0; }
  double reciprocal_condition() { return cholmod_rcond(m_cholmodFactor, &cholmod()); }
  /// Of the factor, once the pattern has been analyzed.
  double bytes() const {
    if (m_cholmodFactor == nullptr) return std::numeric_limits<double>::infinity();
    return sizeof(double) * static_cast<double>(m_cholmodFactor->xsize);
  }
};

}  // namespace trajan
