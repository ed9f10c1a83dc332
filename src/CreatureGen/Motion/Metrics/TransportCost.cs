using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion;

/// <summary>The mechanical cost of transport: work per weight and way, without a unit. A creature with 0.2 does as much work on a metre as lifting itself by 20 cm.</summary>
/// <remarks>
/// The bones' capsules share the creature's mass by their volume. What their kinetic and potential energy gain together from frame to frame is work; what they lose is not given back, and energy may pass from bone
/// to bone. Drag and lift are no part of it: swimmers and fliers compare only among themselves. Based on: G. A. Cavagna, N. C. Heglund, C. R. Taylor, "Mechanical work in terrestrial locomotion" (1977); V. A. Tucker,
/// "The energetic cost of moving about" (1975).
/// </remarks>
public static class TransportCost
{
    private const float Hertz = 60f;
    private const float MinSeconds = 1f;
    private const float MaxSeconds = 6f;

    /// <summary>The cost at a creature's usual speed, straight ahead on flat ground, in the water or in the air; infinity for what does not come on.</summary>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    public static double Of(MotionProfile profile)
    {
        _ = profile ?? throw new ArgumentNullException(nameof(profile));
        Creature creature = profile.Creature;
        var input = new MotionInput(creature.DefaultSpeed, Medium: profile.Flight != null ? MotionMedium.Air : MotionMedium.Ground);
        var animator = new CreatureAnimator(profile);
        IGround ground = FlatGround.Level;
        const float step = 1f / Hertz;
        for (int i = 0; i < MotionTrial.SettleSeconds * Hertz; i++)
        {
            animator.Update(step, input, ground);
        }

        (int Joint, Vector3 Middle, double Mass)[] bones = Weigh(creature);
        var before = new Vector3[bones.Length];
        Place(animator, bones, before);
        Vector3 start = animator.Root.Position;
        float seconds = animator.Frequency > 0f ? Scalar.Clamp(MotionTrial.Cycles / animator.Frequency, MinSeconds, MaxSeconds) : MaxSeconds;
        var now = new Vector3[bones.Length];
        double last = double.NaN;
        double work = 0;
        for (int i = 0; i < seconds * Hertz; i++)
        {
            animator.Update(step, input, ground);
            Place(animator, bones, now);
            double energy = Energy(bones, before, now, step);
            work += energy > last ? energy - last : 0;
            last = energy;
            (before, now) = (now, before);
        }

        double way = Vec.Length(animator.Root.Position - start);
        return way > 0 ? work / (creature.Mass.Mass * StandardGravity.Acceleration * way) : double.PositiveInfinity;
    }

    /// <summary>The middle of each bone's capsule in its joint's space, and its part of the creature's mass.</summary>
    private static (int Joint, Vector3 Middle, double Mass)[] Weigh(Creature creature)
    {
        var bones = new (int Joint, Vector3 Middle, double Mass)[creature.Bones.Count];
        double sum = 0;
        for (int i = 0; i < bones.Length; i++)
        {
            CapsuleCollider capsule = creature.Bones[i];
            double volume = capsule.Radius * capsule.Radius * (Vec.Length(capsule.End - capsule.Start) + (4.0 / 3 * capsule.Radius));
            bones[i] = (capsule.Joint, (capsule.Start + capsule.End) * 0.5f, volume);
            sum += volume;
        }

        for (int i = 0; i < bones.Length; i++)
        {
            bones[i].Mass *= creature.Mass.Mass / sum;
        }

        return bones;
    }

    private static void Place(CreatureAnimator animator, (int Joint, Vector3 Middle, double Mass)[] bones, Vector3[] places)
    {
        Pose pose = animator.ModelPose;
        for (int i = 0; i < bones.Length; i++)
        {
            int joint = bones[i].Joint;
            places[i] = animator.Root.ToWorld(pose.Positions[joint] + Rotation.Rotate(pose.Rotations[joint], bones[i].Middle));
        }
    }

    /// <summary>Energy of all bones in the middle of a frame, joules.</summary>
    private static double Energy((int Joint, Vector3 Middle, double Mass)[] bones, Vector3[] before, Vector3[] now, double step)
    {
        double energy = 0;
        for (int i = 0; i < bones.Length; i++)
        {
            double x = (now[i].X - before[i].X) / step, y = (now[i].Y - before[i].Y) / step, z = (now[i].Z - before[i].Z) / step;
            double height = 0.5 * ((double)now[i].Y + before[i].Y);
            energy += bones[i].Mass * ((0.5 * ((x * x) + (y * y) + (z * z))) + (StandardGravity.Acceleration * height));
        }

        return energy;
    }
}
