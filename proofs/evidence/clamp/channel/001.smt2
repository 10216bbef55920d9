; clamp/channel: ∀ (changed, has), limit, c: ok ⇔ fin(c) ∧ (enabled ∧ in m/s ⇒ pos(max)); then has′ = has ∨ (enabled ∧ c is the velocity, 3 wide, in m/s), changed′ = changed ∨ (enabled ∧ in m/s ∧ ‖c‖ > max), ‖c′‖ ≤ max there, and c′ = c unless ‖c‖ > max
; Each answer has to be unsat, 400 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(define-fun t3 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(declare-const x1 Float64)
(define-fun t6 () Bool (not (or (fp.isNaN x1) (fp.isInfinite x1))))
(define-fun t7 () Bool (and t3 t6))
(declare-const x2 Float64)
(define-fun t10 () Bool (not (or (fp.isNaN x2) (fp.isInfinite x2))))
(define-fun t11 () Bool (and t7 t10))
(declare-const x3 Float64)
(define-fun t14 () Bool (not (or (fp.isNaN x3) (fp.isInfinite x3))))
(define-fun t15 () Bool (and t11 t14))
(define-fun t18 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x0))
(define-fun t19 () Bool (fp.leq (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x0))
(define-fun t20 () Bool (and t3 t18))
(define-fun t24 () Float64 (fp.mul RNE x1 x1))
(define-fun t25 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t24))
(define-fun t26 () Float64 (fp.sqrt RNE t25))
(define-fun t27 () Bool (fp.leq t26 x0))
(define-fun t28 () Bool (and t6 t20))
(define-fun t31 () Bool (not (or (fp.isNaN t26) (fp.isInfinite t26))))
(define-fun t33 () Float64 (fp.mul RNE x0 (fp #b0 #b01111111110 #b1111111111111111111111111111111111111111111111110111)))
(define-fun t34 () Float64 (fp.div RNE t33 t26))
(define-fun t35 () Float64 (fp.mul RNE x1 t34))
(define-fun t36 () Float64 (fp.mul RNE t35 t35))
(define-fun t37 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t36))
(define-fun t38 () Float64 (fp.sqrt RNE t37))
(define-fun t39 () Bool (fp.leq t38 x0))
(define-fun t40 () Bool (= t35 x1))
(define-fun t42 () Bool (and t27 (not t40)))
(define-fun t44 () Bool (= (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x1))
(define-fun t46 () Bool (and t27 (not t44)))
(define-fun t48 () Float64 (fp.abs x1))
(define-fun t49 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t48))
(define-fun t50 () Float64 (fp.div RNE x1 t48))
(define-fun t51 () Float64 (fp.mul RNE t50 t50))
(define-fun t52 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t51))
(define-fun t53 () Float64 (fp.sqrt RNE t52))
(define-fun t54 () Float64 (fp.div RNE t33 t53))
(define-fun t55 () Float64 (fp.mul RNE t50 t54))
(define-fun t56 () Float64 (fp.mul RNE t55 t55))
(define-fun t57 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t56))
(define-fun t58 () Float64 (fp.sqrt RNE t57))
(define-fun t59 () Bool (fp.leq t58 x0))
(define-fun t60 () Bool (= t55 x1))
(define-fun t62 () Bool (and t27 (not t60)))
(define-fun t64 () Float64 (fp.div RNE x1 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t65 () Float64 (fp.mul RNE t64 t64))
(define-fun t66 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t65))
(define-fun t67 () Float64 (fp.sqrt RNE t66))
(define-fun t68 () Float64 (fp.div RNE t33 t67))
(define-fun t69 () Float64 (fp.mul RNE t64 t68))
(define-fun t70 () Float64 (fp.mul RNE t69 t69))
(define-fun t71 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t70))
(define-fun t72 () Float64 (fp.sqrt RNE t71))
(define-fun t73 () Bool (fp.leq t72 x0))
(define-fun t74 () Bool (= t69 x1))
(define-fun t76 () Bool (and t27 (not t74)))
(define-fun t78 () Bool (and t6 t10))
(define-fun t80 () Float64 (fp.mul RNE x2 x2))
(define-fun t81 () Float64 (fp.add RNE t25 t80))
(define-fun t82 () Float64 (fp.sqrt RNE t81))
(define-fun t83 () Bool (fp.leq t82 x0))
(define-fun t84 () Bool (and t20 t78))
(define-fun t87 () Bool (not (or (fp.isNaN t82) (fp.isInfinite t82))))
(define-fun t89 () Float64 (fp.mul RNE x0 (fp #b0 #b01111111110 #b1111111111111111111111111111111111111111111111110110)))
(define-fun t90 () Float64 (fp.div RNE t89 t82))
(define-fun t91 () Float64 (fp.mul RNE x1 t90))
(define-fun t92 () Float64 (fp.mul RNE x2 t90))
(define-fun t93 () Float64 (fp.mul RNE t91 t91))
(define-fun t94 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t93))
(define-fun t95 () Float64 (fp.mul RNE t92 t92))
(define-fun t96 () Float64 (fp.add RNE t94 t95))
(define-fun t97 () Float64 (fp.sqrt RNE t96))
(define-fun t98 () Bool (fp.leq t97 x0))
(define-fun t99 () Bool (= t91 x1))
(define-fun t101 () Bool (and t83 (not t99)))
(define-fun t113 () Float64 (fp.abs x2))
(define-fun t114 () Bool (fp.lt t48 t113))
(define-fun t115 () Float64 (fp.div RNE x1 t113))
(define-fun t116 () Float64 (fp.div RNE x2 t113))
(define-fun t117 () Float64 (fp.mul RNE t115 t115))
(define-fun t118 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t117))
(define-fun t119 () Float64 (fp.mul RNE t116 t116))
(define-fun t120 () Float64 (fp.add RNE t118 t119))
(define-fun t121 () Float64 (fp.sqrt RNE t120))
(define-fun t122 () Float64 (fp.div RNE t89 t121))
(define-fun t123 () Float64 (fp.mul RNE t115 t122))
(define-fun t124 () Float64 (fp.mul RNE t116 t122))
(define-fun t125 () Float64 (fp.mul RNE t123 t123))
(define-fun t126 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t125))
(define-fun t127 () Float64 (fp.mul RNE t124 t124))
(define-fun t128 () Float64 (fp.add RNE t126 t127))
(define-fun t129 () Float64 (fp.sqrt RNE t128))
(define-fun t130 () Bool (fp.leq t129 x0))
(define-fun t139 () Float64 (fp.div RNE x2 t48))
(define-fun t140 () Float64 (fp.mul RNE t139 t139))
(define-fun t141 () Float64 (fp.add RNE t52 t140))
(define-fun t142 () Float64 (fp.sqrt RNE t141))
(define-fun t143 () Float64 (fp.div RNE t89 t142))
(define-fun t144 () Float64 (fp.mul RNE t50 t143))
(define-fun t145 () Float64 (fp.mul RNE t139 t143))
(define-fun t146 () Float64 (fp.mul RNE t144 t144))
(define-fun t147 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t146))
(define-fun t148 () Float64 (fp.mul RNE t145 t145))
(define-fun t149 () Float64 (fp.add RNE t147 t148))
(define-fun t150 () Float64 (fp.sqrt RNE t149))
(define-fun t151 () Bool (fp.leq t150 x0))
(define-fun t160 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t113))
(define-fun t161 () Float64 (fp.div RNE x2 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t162 () Float64 (fp.mul RNE t161 t161))
(define-fun t163 () Float64 (fp.add RNE t66 t162))
(define-fun t164 () Float64 (fp.sqrt RNE t163))
(define-fun t165 () Float64 (fp.div RNE t89 t164))
(define-fun t166 () Float64 (fp.mul RNE t64 t165))
(define-fun t167 () Float64 (fp.mul RNE t161 t165))
(define-fun t168 () Float64 (fp.mul RNE t166 t166))
(define-fun t169 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t168))
(define-fun t170 () Float64 (fp.mul RNE t167 t167))
(define-fun t171 () Float64 (fp.add RNE t169 t170))
(define-fun t172 () Float64 (fp.sqrt RNE t171))
(define-fun t173 () Bool (fp.leq t172 x0))
(define-fun t182 () Bool (and t14 t78))
(define-fun t184 () Float64 (fp.mul RNE x3 x3))
(define-fun t185 () Float64 (fp.add RNE t81 t184))
(define-fun t186 () Float64 (fp.sqrt RNE t185))
(define-fun t187 () Bool (fp.leq t186 x0))
(define-fun t188 () Bool (and t20 t182))
(define-fun t191 () Bool (not (or (fp.isNaN t186) (fp.isInfinite t186))))
(define-fun t193 () Float64 (fp.mul RNE x0 (fp #b0 #b01111111110 #b1111111111111111111111111111111111111111111111110101)))
(define-fun t194 () Float64 (fp.div RNE t193 t186))
(define-fun t195 () Float64 (fp.mul RNE x1 t194))
(define-fun t196 () Float64 (fp.mul RNE x2 t194))
(define-fun t197 () Float64 (fp.mul RNE x3 t194))
(define-fun t198 () Float64 (fp.mul RNE t195 t195))
(define-fun t199 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t198))
(define-fun t200 () Float64 (fp.mul RNE t196 t196))
(define-fun t201 () Float64 (fp.add RNE t199 t200))
(define-fun t202 () Float64 (fp.mul RNE t197 t197))
(define-fun t203 () Float64 (fp.add RNE t201 t202))
(define-fun t204 () Float64 (fp.sqrt RNE t203))
(define-fun t205 () Bool (fp.leq t204 x0))
(define-fun t226 () Float64 (fp.abs x3))
(define-fun t227 () Bool (fp.lt t113 t226))
(define-fun t228 () Float64 (fp.div RNE x1 t226))
(define-fun t229 () Float64 (fp.div RNE x2 t226))
(define-fun t230 () Float64 (fp.div RNE x3 t226))
(define-fun t231 () Float64 (fp.mul RNE t228 t228))
(define-fun t232 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t231))
(define-fun t233 () Float64 (fp.mul RNE t229 t229))
(define-fun t234 () Float64 (fp.add RNE t232 t233))
(define-fun t235 () Float64 (fp.mul RNE t230 t230))
(define-fun t236 () Float64 (fp.add RNE t234 t235))
(define-fun t237 () Float64 (fp.sqrt RNE t236))
(define-fun t238 () Float64 (fp.div RNE t193 t237))
(define-fun t239 () Float64 (fp.mul RNE t228 t238))
(define-fun t240 () Float64 (fp.mul RNE t229 t238))
(define-fun t241 () Float64 (fp.mul RNE t230 t238))
(define-fun t242 () Float64 (fp.mul RNE t239 t239))
(define-fun t243 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t242))
(define-fun t244 () Float64 (fp.mul RNE t240 t240))
(define-fun t245 () Float64 (fp.add RNE t243 t244))
(define-fun t246 () Float64 (fp.mul RNE t241 t241))
(define-fun t247 () Float64 (fp.add RNE t245 t246))
(define-fun t248 () Float64 (fp.sqrt RNE t247))
(define-fun t249 () Bool (fp.leq t248 x0))
(define-fun t262 () Float64 (fp.div RNE x3 t113))
(define-fun t263 () Float64 (fp.mul RNE t262 t262))
(define-fun t264 () Float64 (fp.add RNE t120 t263))
(define-fun t265 () Float64 (fp.sqrt RNE t264))
(define-fun t266 () Float64 (fp.div RNE t193 t265))
(define-fun t267 () Float64 (fp.mul RNE t115 t266))
(define-fun t268 () Float64 (fp.mul RNE t116 t266))
(define-fun t269 () Float64 (fp.mul RNE t262 t266))
(define-fun t270 () Float64 (fp.mul RNE t267 t267))
(define-fun t271 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t270))
(define-fun t272 () Float64 (fp.mul RNE t268 t268))
(define-fun t273 () Float64 (fp.add RNE t271 t272))
(define-fun t274 () Float64 (fp.mul RNE t269 t269))
(define-fun t275 () Float64 (fp.add RNE t273 t274))
(define-fun t276 () Float64 (fp.sqrt RNE t275))
(define-fun t277 () Bool (fp.leq t276 x0))
(define-fun t290 () Bool (fp.lt t48 t226))
(define-fun t291 () Float64 (fp.div RNE x3 t48))
(define-fun t292 () Float64 (fp.mul RNE t291 t291))
(define-fun t293 () Float64 (fp.add RNE t141 t292))
(define-fun t294 () Float64 (fp.sqrt RNE t293))
(define-fun t295 () Float64 (fp.div RNE t193 t294))
(define-fun t296 () Float64 (fp.mul RNE t50 t295))
(define-fun t297 () Float64 (fp.mul RNE t139 t295))
(define-fun t298 () Float64 (fp.mul RNE t291 t295))
(define-fun t299 () Float64 (fp.mul RNE t296 t296))
(define-fun t300 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t299))
(define-fun t301 () Float64 (fp.mul RNE t297 t297))
(define-fun t302 () Float64 (fp.add RNE t300 t301))
(define-fun t303 () Float64 (fp.mul RNE t298 t298))
(define-fun t304 () Float64 (fp.add RNE t302 t303))
(define-fun t305 () Float64 (fp.sqrt RNE t304))
(define-fun t306 () Bool (fp.leq t305 x0))
(define-fun t319 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t226))
(define-fun t320 () Float64 (fp.div RNE x3 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t321 () Float64 (fp.mul RNE t320 t320))
(define-fun t322 () Float64 (fp.add RNE t163 t321))
(define-fun t323 () Float64 (fp.sqrt RNE t322))
(define-fun t324 () Float64 (fp.div RNE t193 t323))
(define-fun t325 () Float64 (fp.mul RNE t64 t324))
(define-fun t326 () Float64 (fp.mul RNE t161 t324))
(define-fun t327 () Float64 (fp.mul RNE t320 t324))
(define-fun t328 () Float64 (fp.mul RNE t325 t325))
(define-fun t329 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t328))
(define-fun t330 () Float64 (fp.mul RNE t326 t326))
(define-fun t331 () Float64 (fp.add RNE t329 t330))
(define-fun t332 () Float64 (fp.mul RNE t327 t327))
(define-fun t333 () Float64 (fp.add RNE t331 t332))
(define-fun t334 () Float64 (fp.sqrt RNE t333))
(define-fun t335 () Bool (fp.leq t334 x0))
(declare-const x4 Float64)
(define-fun t349 () Bool (not (or (fp.isNaN x4) (fp.isInfinite x4))))
(define-fun t350 () Bool (and t182 t349))
(define-fun t352 () Float64 (fp.mul RNE x4 x4))
(define-fun t353 () Float64 (fp.add RNE t185 t352))
(define-fun t354 () Float64 (fp.sqrt RNE t353))
(define-fun t355 () Bool (fp.leq t354 x0))
(define-fun t356 () Bool (and t20 t350))
(define-fun t359 () Bool (not (or (fp.isNaN t354) (fp.isInfinite t354))))
(define-fun t361 () Float64 (fp.mul RNE x0 (fp #b0 #b01111111110 #b1111111111111111111111111111111111111111111111110100)))
(define-fun t362 () Float64 (fp.div RNE t361 t354))
(define-fun t363 () Float64 (fp.mul RNE x1 t362))
(define-fun t364 () Float64 (fp.mul RNE x2 t362))
(define-fun t365 () Float64 (fp.mul RNE x3 t362))
(define-fun t366 () Float64 (fp.mul RNE x4 t362))
(define-fun t367 () Float64 (fp.mul RNE t363 t363))
(define-fun t368 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t367))
(define-fun t369 () Float64 (fp.mul RNE t364 t364))
(define-fun t370 () Float64 (fp.add RNE t368 t369))
(define-fun t371 () Float64 (fp.mul RNE t365 t365))
(define-fun t372 () Float64 (fp.add RNE t370 t371))
(define-fun t373 () Float64 (fp.mul RNE t366 t366))
(define-fun t374 () Float64 (fp.add RNE t372 t373))
(define-fun t375 () Float64 (fp.sqrt RNE t374))
(define-fun t376 () Bool (fp.leq t375 x0))
(define-fun t403 () Float64 (fp.abs x4))
(define-fun t404 () Bool (fp.lt t226 t403))
(define-fun t405 () Float64 (fp.div RNE x1 t403))
(define-fun t406 () Float64 (fp.div RNE x2 t403))
(define-fun t407 () Float64 (fp.div RNE x3 t403))
(define-fun t408 () Float64 (fp.div RNE x4 t403))
(define-fun t409 () Float64 (fp.mul RNE t405 t405))
(define-fun t410 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t409))
(define-fun t411 () Float64 (fp.mul RNE t406 t406))
(define-fun t412 () Float64 (fp.add RNE t410 t411))
(define-fun t413 () Float64 (fp.mul RNE t407 t407))
(define-fun t414 () Float64 (fp.add RNE t412 t413))
(define-fun t415 () Float64 (fp.mul RNE t408 t408))
(define-fun t416 () Float64 (fp.add RNE t414 t415))
(define-fun t417 () Float64 (fp.sqrt RNE t416))
(define-fun t418 () Float64 (fp.div RNE t361 t417))
(define-fun t419 () Float64 (fp.mul RNE t405 t418))
(define-fun t420 () Float64 (fp.mul RNE t406 t418))
(define-fun t421 () Float64 (fp.mul RNE t407 t418))
(define-fun t422 () Float64 (fp.mul RNE t408 t418))
(define-fun t423 () Float64 (fp.mul RNE t419 t419))
(define-fun t424 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t423))
(define-fun t425 () Float64 (fp.mul RNE t420 t420))
(define-fun t426 () Float64 (fp.add RNE t424 t425))
(define-fun t427 () Float64 (fp.mul RNE t421 t421))
(define-fun t428 () Float64 (fp.add RNE t426 t427))
(define-fun t429 () Float64 (fp.mul RNE t422 t422))
(define-fun t430 () Float64 (fp.add RNE t428 t429))
(define-fun t431 () Float64 (fp.sqrt RNE t430))
(define-fun t432 () Bool (fp.leq t431 x0))
(define-fun t449 () Float64 (fp.div RNE x4 t226))
(define-fun t450 () Float64 (fp.mul RNE t449 t449))
(define-fun t451 () Float64 (fp.add RNE t236 t450))
(define-fun t452 () Float64 (fp.sqrt RNE t451))
(define-fun t453 () Float64 (fp.div RNE t361 t452))
(define-fun t454 () Float64 (fp.mul RNE t228 t453))
(define-fun t455 () Float64 (fp.mul RNE t229 t453))
(define-fun t456 () Float64 (fp.mul RNE t230 t453))
(define-fun t457 () Float64 (fp.mul RNE t449 t453))
(define-fun t458 () Float64 (fp.mul RNE t454 t454))
(define-fun t459 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t458))
(define-fun t460 () Float64 (fp.mul RNE t455 t455))
(define-fun t461 () Float64 (fp.add RNE t459 t460))
(define-fun t462 () Float64 (fp.mul RNE t456 t456))
(define-fun t463 () Float64 (fp.add RNE t461 t462))
(define-fun t464 () Float64 (fp.mul RNE t457 t457))
(define-fun t465 () Float64 (fp.add RNE t463 t464))
(define-fun t466 () Float64 (fp.sqrt RNE t465))
(define-fun t467 () Bool (fp.leq t466 x0))
(define-fun t484 () Bool (fp.lt t113 t403))
(define-fun t485 () Float64 (fp.div RNE x4 t113))
(define-fun t486 () Float64 (fp.mul RNE t485 t485))
(define-fun t487 () Float64 (fp.add RNE t264 t486))
(define-fun t488 () Float64 (fp.sqrt RNE t487))
(define-fun t489 () Float64 (fp.div RNE t361 t488))
(define-fun t490 () Float64 (fp.mul RNE t115 t489))
(define-fun t491 () Float64 (fp.mul RNE t116 t489))
(define-fun t492 () Float64 (fp.mul RNE t262 t489))
(define-fun t493 () Float64 (fp.mul RNE t485 t489))
(define-fun t494 () Float64 (fp.mul RNE t490 t490))
(define-fun t495 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t494))
(define-fun t496 () Float64 (fp.mul RNE t491 t491))
(define-fun t497 () Float64 (fp.add RNE t495 t496))
(define-fun t498 () Float64 (fp.mul RNE t492 t492))
(define-fun t499 () Float64 (fp.add RNE t497 t498))
(define-fun t500 () Float64 (fp.mul RNE t493 t493))
(define-fun t501 () Float64 (fp.add RNE t499 t500))
(define-fun t502 () Float64 (fp.sqrt RNE t501))
(define-fun t503 () Bool (fp.leq t502 x0))
(define-fun t520 () Bool (fp.lt t48 t403))
(define-fun t521 () Float64 (fp.div RNE x4 t48))
(define-fun t522 () Float64 (fp.mul RNE t521 t521))
(define-fun t523 () Float64 (fp.add RNE t293 t522))
(define-fun t524 () Float64 (fp.sqrt RNE t523))
(define-fun t525 () Float64 (fp.div RNE t361 t524))
(define-fun t526 () Float64 (fp.mul RNE t50 t525))
(define-fun t527 () Float64 (fp.mul RNE t139 t525))
(define-fun t528 () Float64 (fp.mul RNE t291 t525))
(define-fun t529 () Float64 (fp.mul RNE t521 t525))
(define-fun t530 () Float64 (fp.mul RNE t526 t526))
(define-fun t531 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t530))
(define-fun t532 () Float64 (fp.mul RNE t527 t527))
(define-fun t533 () Float64 (fp.add RNE t531 t532))
(define-fun t534 () Float64 (fp.mul RNE t528 t528))
(define-fun t535 () Float64 (fp.add RNE t533 t534))
(define-fun t536 () Float64 (fp.mul RNE t529 t529))
(define-fun t537 () Float64 (fp.add RNE t535 t536))
(define-fun t538 () Float64 (fp.sqrt RNE t537))
(define-fun t539 () Bool (fp.leq t538 x0))
(define-fun t556 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t403))
(define-fun t557 () Float64 (fp.div RNE x4 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t558 () Float64 (fp.mul RNE t557 t557))
(define-fun t559 () Float64 (fp.add RNE t322 t558))
(define-fun t560 () Float64 (fp.sqrt RNE t559))
(define-fun t561 () Float64 (fp.div RNE t361 t560))
(define-fun t562 () Float64 (fp.mul RNE t64 t561))
(define-fun t563 () Float64 (fp.mul RNE t161 t561))
(define-fun t564 () Float64 (fp.mul RNE t320 t561))
(define-fun t565 () Float64 (fp.mul RNE t557 t561))
(define-fun t566 () Float64 (fp.mul RNE t562 t562))
(define-fun t567 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t566))
(define-fun t568 () Float64 (fp.mul RNE t563 t563))
(define-fun t569 () Float64 (fp.add RNE t567 t568))
(define-fun t570 () Float64 (fp.mul RNE t564 t564))
(define-fun t571 () Float64 (fp.add RNE t569 t570))
(define-fun t572 () Float64 (fp.mul RNE t565 t565))
(define-fun t573 () Float64 (fp.add RNE t571 t572))
(define-fun t574 () Float64 (fp.sqrt RNE t573))
(define-fun t575 () Bool (fp.leq t574 x0))
(push 1) ; a channel in m/s is within the limit
(assert t3)(assert t18)(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t3)(assert t18)(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t3)(assert t18)(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t3)(assert t18)(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t3)(assert t18)(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t3)(assert t18)(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t3)(assert t18)(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t3)(assert t18)(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert (not t31))(assert (not t49))(assert (not t73))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert (not t31))(assert (not t49))(assert (not t73))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert (not t31))(assert (not t49))(assert (not t73))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert (not t31))(assert (not t49))(assert (not t73))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert (not t31))(assert (not t49))(assert (not t73))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert (not t31))(assert (not t49))(assert (not t73))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert (not t31))(assert (not t49))(assert (not t73))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert (not t31))(assert (not t49))(assert (not t73))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert (not t31))(assert t49)(assert (not t59))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert (not t31))(assert t49)(assert (not t59))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert (not t31))(assert t49)(assert (not t59))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert (not t31))(assert t49)(assert (not t59))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert (not t31))(assert t49)(assert (not t59))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert (not t31))(assert t49)(assert (not t59))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert (not t31))(assert t49)(assert (not t59))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert (not t31))(assert t49)(assert (not t59))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert t31)(assert (not t39))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert t31)(assert (not t39))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert t31)(assert (not t39))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert t31)(assert (not t39))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert t31)(assert (not t39))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert t31)(assert (not t39))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert t31)(assert (not t39))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t3)(assert t18)(assert (not t27))(assert t31)(assert (not t39))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert (not t49))(assert (not t160))(assert (not t173))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert (not t49))(assert (not t160))(assert (not t173))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert (not t49))(assert (not t160))(assert (not t173))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert (not t49))(assert (not t160))(assert (not t173))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert (not t49))(assert (not t160))(assert (not t173))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert (not t49))(assert (not t160))(assert (not t173))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert (not t49))(assert (not t160))(assert (not t173))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert (not t49))(assert (not t160))(assert (not t173))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert (not t49))(assert t160)(assert (not t130))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert (not t49))(assert t160)(assert (not t130))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert (not t49))(assert t160)(assert (not t130))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert (not t49))(assert t160)(assert (not t130))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert (not t49))(assert t160)(assert (not t130))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert (not t49))(assert t160)(assert (not t130))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert (not t49))(assert t160)(assert (not t130))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert (not t49))(assert t160)(assert (not t130))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert t49)(assert (not t114))(assert (not t151))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert t49)(assert (not t114))(assert (not t151))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert t49)(assert (not t114))(assert (not t151))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert t49)(assert (not t114))(assert (not t151))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert t49)(assert (not t114))(assert (not t151))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert t49)(assert (not t114))(assert (not t151))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert t49)(assert (not t114))(assert (not t151))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert t49)(assert (not t114))(assert (not t151))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert t49)(assert t114)(assert (not t130))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert t49)(assert t114)(assert (not t130))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert t49)(assert t114)(assert (not t130))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert t49)(assert t114)(assert (not t130))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert t49)(assert t114)(assert (not t130))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert t49)(assert t114)(assert (not t130))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert t49)(assert t114)(assert (not t130))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert (not t87))(assert t49)(assert t114)(assert (not t130))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert t87)(assert (not t98))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert t87)(assert (not t98))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert t87)(assert (not t98))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert t87)(assert (not t98))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert t87)(assert (not t98))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert t87)(assert (not t98))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert t87)(assert (not t98))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t3)(assert t18)(assert (not t83))(assert t87)(assert (not t98))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert (not t160))(assert (not t319))(assert (not t335))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert (not t160))(assert (not t319))(assert (not t335))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert (not t160))(assert (not t319))(assert (not t335))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert (not t160))(assert (not t319))(assert (not t335))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert (not t160))(assert (not t319))(assert (not t335))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert (not t160))(assert (not t319))(assert (not t335))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert (not t160))(assert (not t319))(assert (not t335))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert (not t160))(assert (not t319))(assert (not t335))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert (not t160))(assert t319)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert (not t160))(assert t319)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert (not t160))(assert t319)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert (not t160))(assert t319)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert (not t160))(assert t319)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert (not t160))(assert t319)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert (not t160))(assert t319)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert (not t160))(assert t319)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert t160)(assert (not t227))(assert (not t277))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert t160)(assert (not t227))(assert (not t277))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert t160)(assert (not t227))(assert (not t277))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert t160)(assert (not t227))(assert (not t277))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert t160)(assert (not t227))(assert (not t277))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert t160)(assert (not t227))(assert (not t277))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert t160)(assert (not t227))(assert (not t277))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert t160)(assert (not t227))(assert (not t277))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert t160)(assert t227)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert t160)(assert t227)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert t160)(assert t227)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert t160)(assert t227)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert t160)(assert t227)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert t160)(assert t227)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert t160)(assert t227)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert (not t49))(assert t160)(assert t227)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert (not t114))(assert (not t290))(assert (not t306))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert (not t114))(assert (not t290))(assert (not t306))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert (not t114))(assert (not t290))(assert (not t306))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert (not t114))(assert (not t290))(assert (not t306))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert (not t114))(assert (not t290))(assert (not t306))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert (not t114))(assert (not t290))(assert (not t306))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert (not t114))(assert (not t290))(assert (not t306))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert (not t114))(assert (not t290))(assert (not t306))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert (not t114))(assert t290)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert (not t114))(assert t290)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert (not t114))(assert t290)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert (not t114))(assert t290)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert (not t114))(assert t290)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert (not t114))(assert t290)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert (not t114))(assert t290)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert (not t114))(assert t290)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert t114)(assert (not t227))(assert (not t277))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert t114)(assert (not t227))(assert (not t277))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert t114)(assert (not t227))(assert (not t277))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert t114)(assert (not t227))(assert (not t277))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert t114)(assert (not t227))(assert (not t277))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert t114)(assert (not t227))(assert (not t277))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert t114)(assert (not t227))(assert (not t277))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert t114)(assert (not t227))(assert (not t277))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert t114)(assert t227)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert t114)(assert t227)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert t114)(assert t227)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert t114)(assert t227)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert t114)(assert t227)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert t114)(assert t227)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert t114)(assert t227)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert (not t191))(assert t49)(assert t114)(assert t227)(assert (not t249))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert t191)(assert (not t205))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert t191)(assert (not t205))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert t191)(assert (not t205))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert t191)(assert (not t205))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert t191)(assert (not t205))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert t191)(assert (not t205))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert t191)(assert (not t205))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t3)(assert t18)(assert (not t187))(assert t191)(assert (not t205))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert (not t319))(assert (not t556))(assert (not t575))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert (not t319))(assert (not t556))(assert (not t575))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert (not t319))(assert (not t556))(assert (not t575))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert (not t319))(assert (not t556))(assert (not t575))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert (not t319))(assert (not t556))(assert (not t575))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert (not t319))(assert (not t556))(assert (not t575))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert (not t319))(assert (not t556))(assert (not t575))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert (not t319))(assert (not t556))(assert (not t575))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert (not t319))(assert t556)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert (not t319))(assert t556)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert (not t319))(assert t556)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert (not t319))(assert t556)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert (not t319))(assert t556)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert (not t319))(assert t556)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert (not t319))(assert t556)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert (not t319))(assert t556)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert t319)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert t319)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert t319)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert t319)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert t319)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert t319)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert t319)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert t319)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert t319)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert t319)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert t319)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert t319)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert t319)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert t319)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert t319)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert (not t160))(assert t319)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert (not t227))(assert (not t484))(assert (not t503))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert (not t227))(assert (not t484))(assert (not t503))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert (not t227))(assert (not t484))(assert (not t503))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert (not t227))(assert (not t484))(assert (not t503))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert (not t227))(assert (not t484))(assert (not t503))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert (not t227))(assert (not t484))(assert (not t503))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert (not t227))(assert (not t484))(assert (not t503))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert (not t227))(assert (not t484))(assert (not t503))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert (not t227))(assert t484)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert (not t227))(assert t484)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert (not t227))(assert t484)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert (not t227))(assert t484)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert (not t227))(assert t484)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert (not t227))(assert t484)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert (not t227))(assert t484)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert (not t227))(assert t484)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert t227)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert t227)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert t227)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert t227)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert t227)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert t227)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert t227)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert t227)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert t227)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert t227)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert t227)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert t227)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert t227)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert t227)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert t227)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert (not t49))(assert t160)(assert t227)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert (not t290))(assert (not t520))(assert (not t539))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert (not t290))(assert (not t520))(assert (not t539))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert (not t290))(assert (not t520))(assert (not t539))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert (not t290))(assert (not t520))(assert (not t539))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert (not t290))(assert (not t520))(assert (not t539))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert (not t290))(assert (not t520))(assert (not t539))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert (not t290))(assert (not t520))(assert (not t539))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert (not t290))(assert (not t520))(assert (not t539))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert (not t290))(assert t520)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert (not t290))(assert t520)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert (not t290))(assert t520)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert (not t290))(assert t520)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert (not t290))(assert t520)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert (not t290))(assert t520)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert (not t290))(assert t520)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert (not t290))(assert t520)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert t290)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert t290)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert t290)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert t290)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert t290)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert t290)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert t290)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert t290)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert t290)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert t290)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert t290)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert t290)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert t290)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert t290)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert t290)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert (not t114))(assert t290)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert (not t227))(assert (not t484))(assert (not t503))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert (not t227))(assert (not t484))(assert (not t503))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert (not t227))(assert (not t484))(assert (not t503))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert (not t227))(assert (not t484))(assert (not t503))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert (not t227))(assert (not t484))(assert (not t503))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert (not t227))(assert (not t484))(assert (not t503))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert (not t227))(assert (not t484))(assert (not t503))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert (not t227))(assert (not t484))(assert (not t503))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert (not t227))(assert t484)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert (not t227))(assert t484)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert (not t227))(assert t484)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert (not t227))(assert t484)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert (not t227))(assert t484)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert (not t227))(assert t484)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert (not t227))(assert t484)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert (not t227))(assert t484)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert t227)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert t227)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert t227)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert t227)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert t227)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert t227)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert t227)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert t227)(assert (not t404))(assert (not t467))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert t227)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert t227)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert t227)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert t227)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert t227)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert t227)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert t227)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert (not t359))(assert t49)(assert t114)(assert t227)(assert t404)(assert (not t432))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert t359)(assert (not t376))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert t359)(assert (not t376))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert t359)(assert (not t376))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert t359)(assert (not t376))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert t359)(assert (not t376))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert t359)(assert (not t376))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert t359)(assert (not t376))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t6)(assert t10)(assert t14)(assert t349)(assert t3)(assert t18)(assert (not t355))(assert t359)(assert (not t376))(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t27)(assert (not t27))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t39)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t59)(assert (not t59))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t73)(assert (not t73))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t83)(assert (not t83))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t98)(assert (not t98))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t130)(assert (not t130))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t151)(assert (not t151))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t173)(assert (not t173))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t187)(assert (not t187))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t205)(assert (not t205))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t249)(assert (not t249))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t277)(assert (not t277))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t306)(assert (not t306))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t335)(assert (not t335))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t355)(assert (not t355))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t376)(assert (not t376))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t432)(assert (not t432))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t467)(assert (not t467))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t503)(assert (not t503))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t539)(assert (not t539))
(check-sat)
(pop 1)
(push 1) ; a channel in m/s is within the limit
(assert t575)(assert (not t575))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t3)(assert (not t3))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t3))(assert (not (not t3)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t6))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t3)(assert t6)(assert (not t7))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t3))(assert (not (not t7)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t3)(assert (not t6))(assert (not (not t7)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t3)(assert t6)(assert t10)(assert (not t11))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t3))(assert (not (not t11)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t3)(assert (not t6))(assert (not (not t11)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t3)(assert t6)(assert (not t10))(assert (not (not t11)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t3)(assert t6)(assert t10)(assert t14)(assert (not t15))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t3))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t3)(assert (not t6))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t3)(assert t6)(assert (not t10))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t3)(assert t6)(assert t10)(assert (not t14))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert (not (not t6)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert t10)(assert (not t78))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert (not (not t78)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t10))(assert (not (not t78)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert t10)(assert t14)(assert (not t182))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert (not (not t182)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t10))(assert (not (not t182)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert t10)(assert (not t14))(assert (not (not t182)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert t10)(assert t14)(assert t349)(assert (not t350))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert (not (not t350)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t10))(assert (not (not t350)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert t10)(assert (not t14))(assert (not (not t350)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert t10)(assert t14)(assert (not t349))(assert (not (not t350)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t3)(assert t18)(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t3)(assert t18)(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t3)(assert t18)(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t3)(assert t18)(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t27)(assert (not t27))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert (not t27))(assert (not (not t27)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t83)(assert (not t83))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert (not t83))(assert (not (not t83)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t187)(assert (not t187))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert (not t187))(assert (not (not t187)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t355)(assert (not t355))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert (not t355))(assert (not (not t355)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert (not t3))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert (not t3))(assert (not (not t3)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t6)(assert (not t6))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert t6)(assert (not t7))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert (not t3))(assert (not (not t7)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert (not t6))(assert (not (not t7)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert t6)(assert t10)(assert (not t11))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert (not t3))(assert (not (not t11)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert (not t6))(assert (not (not t11)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert t6)(assert (not t10))(assert (not (not t11)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert t6)(assert t10)(assert t14)(assert (not t15))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert (not t3))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert (not t6))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert t6)(assert (not t10))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert t6)(assert t10)(assert (not t14))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert t18)(assert (not t20))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert (not t3))(assert (not (not t20)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert (not t18))(assert (not (not t20)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert (not t6))(assert (not (not t6)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert t6)(assert t18)(assert (not t28))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert (not t3))(assert t6)(assert (not (not t28)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert t6)(assert (not t18))(assert (not (not t28)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert (not t6))(assert (not (not t28)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t6)(assert t10)(assert (not t78))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert (not t6))(assert (not (not t78)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t6)(assert (not t10))(assert (not (not t78)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert t6)(assert t10)(assert t18)(assert (not t84))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert (not t3))(assert t6)(assert t10)(assert (not (not t84)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert t6)(assert t10)(assert (not t18))(assert (not (not t84)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert (not t6))(assert (not (not t84)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t6)(assert (not t10))(assert (not (not t84)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t6)(assert t10)(assert t14)(assert (not t182))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert (not t6))(assert (not (not t182)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t6)(assert (not t10))(assert (not (not t182)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t6)(assert t10)(assert (not t14))(assert (not (not t182)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert t6)(assert t10)(assert t14)(assert t18)(assert (not t188))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert (not t3))(assert t6)(assert t10)(assert t14)(assert (not (not t188)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert t6)(assert t10)(assert t14)(assert (not t18))(assert (not (not t188)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert (not t6))(assert (not (not t188)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t6)(assert (not t10))(assert (not (not t188)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t6)(assert t10)(assert (not t14))(assert (not (not t188)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t6)(assert t10)(assert t14)(assert t349)(assert (not t350))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert (not t6))(assert (not (not t350)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t6)(assert (not t10))(assert (not (not t350)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t6)(assert t10)(assert (not t14))(assert (not (not t350)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t6)(assert t10)(assert t14)(assert (not t349))(assert (not (not t350)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert t6)(assert t10)(assert t14)(assert t18)(assert t349)(assert (not t356))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert (not t3))(assert t6)(assert t10)(assert t14)(assert t349)(assert (not (not t356)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t3)(assert t6)(assert t10)(assert t14)(assert (not t18))(assert t349)(assert (not (not t356)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert (not t6))(assert (not (not t356)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t6)(assert (not t10))(assert (not (not t356)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t6)(assert t10)(assert (not t14))(assert (not (not t356)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when finite, and the bound is one
(assert t6)(assert t10)(assert t14)(assert (not t349))(assert (not (not t356)))
(check-sat)
(pop 1)
(push 1) ; what is not above the limit is as it was
(assert (not t27))(assert (not (not t42)))
(check-sat)
(pop 1)
(push 1) ; what is not above the limit is as it was
(assert (not t27))(assert (not (not t46)))
(check-sat)
(pop 1)
(push 1) ; what is not above the limit is as it was
(assert (not t27))(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; what is not above the limit is as it was
(assert (not t27))(assert (not (not t76)))
(check-sat)
(pop 1)
(push 1) ; what is not above the limit is as it was
(assert (not t83))(assert (not (not t101)))
(check-sat)
(pop 1)
