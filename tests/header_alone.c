/* SPDX-License-Identifier: MIT */
#include "reprise/reprise.h"

RepriseResult headerAlone(void);
RepriseResult headerAlone(void) {
  RepriseFrame frame = {0};
  frame.size = sizeof(frame);
  return frame.size > 0 ? REPRISE_SUCCESS : REPRISE_ERROR_DEVICE;
}
