using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Metrics;

namespace CreatureGen.Motion.Metrics;

/// <summary>The mechanical cost of transport: work per weight and way, without a unit. A creature with 0.2 does as much work on a metre as lifting itself by 20 cm.</summary>
/// <remarks>
/// The bones' capsules share the creature's mass by their volume. Work is what energy gains from frame to frame; what it loses is not given back. It is counted for the centre of mass (kinetic and potential energy), and for each
/// limb and the rest of the body (kinetic energy about the centre of mass): bones of one limb may pass energy to each other, limbs may not. What crawls rubs its belly on the ground. Drag and lift are no part of it: swimmers and fliers compare only among
/// themselves. Based on: G. A. Cavagna and M. Kaneko, "Mechanical work and efficiency in level walking and running" (1977); V. A. Tucker, "The energetic cost of moving about" (1975).
/// </remarks>
public static class TransportCost
{
    /// <summary>Friction of a belly that slides ahead over its weight. Source: D. L. Hu, J. Nirody, T. Scott, M. J. Shelley, "The mechanics of slithering locomotion" (2009).</summary>
    private const double BellyFriction = 0.11;

    private const float Hertz = 60f;
    private const float MinSeconds = 1f;
    private const float MaxSeconds = 6f;

    /// <summary>The cost at a creature's usual speed, straight ahead on flat ground, in the water or in the air; infinity for what does not come on.</summary>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    public static double Of(MotionProfile profile)
    {
        _ = profile ?? throw new ArgumentNullException(nameof(profile));
        MotionSubject subject = profile.Subject;
        var input = new MotionInput(subject.DefaultSpeed, Medium: profile.Flight != null ? MotionMedium.Air : MotionMedium.Ground);
        var animator = new CreatureAnimator(profile);
        IGround ground = FlatGround.Level;
        const float step = 1f / Hertz;
        for (int i = 0; i < MotionTrial.SettleSeconds * Hertz; i++)
        {
            animator.Update(step, input, ground);
        }

        var masses = new PointMasses(subject);
        masses.Move(animator);
        Vector3 start = animator.Root.Position;
        float seconds = animator.Frequency > 0f ? Scalar.Clamp(MotionTrial.Cycles / animator.Frequency, MinSeconds, MaxSeconds) : MaxSeconds;
        double[] last = Array.Empty<double>();
        double work = 0;
        for (int i = 0; i < seconds * Hertz; i++)
        {
            animator.Update(step, input, ground);
            masses.Move(animator);
            double[] energies = masses.Energies(step);
            for (int k = 0; k < last.Length; k++)
            {
                work += Math.Max(0, energies[k] - last[k]);
            }

            last = energies;
        }

        double way = Vec.Length(animator.Root.Position - start);
        double friction = profile.Slither != null ? BellyFriction : 0;
        return way > 0 ? friction + (work / (subject.Mass.Mass * StandardGravity.Acceleration * way)) : double.PositiveInfinity;
    }
}
