using System;
using System.Numerics;
using CreatureGen.Animation.Ik;
using CreatureGen.Animation.Poses;
using CreatureGen.Animation.RootMotion;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Animation.Springs;

/// <summary>Lets tails, ears, feelers and the like swing after any motion. Nothing is allocated once the colliders have been seen.</summary>
/// <remarks>
/// <para>Each bone's tip hangs on a spring at its goal, which is where the animated pose of this very frame would have it, its parent's swing taken over by a share. The spring is stepped at 120 Hz, whatever the frame
/// rate, by its exact solution (<see cref="DampedSpring"/>), relative to the velocity of its goal: x″ = ω²(goal − x) − 2ζω(x′ − goal′) + gravity. A damping relative to the world would bend tails back when running.
/// Then the tip is brought into a cone about its goal, out of the colliders, and back to the length of its bone; the correction changes the velocity by itself over the step. The bone is turned by the
/// smallest rotation that points it at the tip.</para>
/// <para>The animated pose is interpolated within the frame for the substeps, and offsets from the goals are interpolated for time left over, so nothing lags and nothing trembles at frame rates that are no divisor of 120 Hz.</para>
/// <para>Based on: T. Jakobsen, "Advanced character physics" (2001), for projection; M. Müller et al., "Position based dynamics" (2007), for the velocity; VRM's spring bones for goals, tips and centre space.</para>
/// </remarks>
public static class SpringBones
{
    /// <summary>Length of a substep, seconds.</summary>
    public const float Substep = 1f / 120f;

    /// <summary>A step longer than this is a pause, not motion: shapes are kept and nothing is simulated. Seconds.</summary>
    public const float LongestStep = 0.25f;

    private const int CollisionRounds = 2;

    /// <summary>Lets time pass and poses the joints.</summary>
    /// <param name="rig">The joints.</param>
    /// <param name="state">Made for this rig; kept by the caller.</param>
    /// <param name="settings">How they move.</param>
    /// <param name="root">Where the creature is now; <see cref="RootPlace.Identity"/> to feel nothing of its movement.</param>
    /// <param name="colliders">What they stay out of; none of it carried by the joints themselves.</param>
    /// <param name="seconds">Time since the last call; 0 poses again without moving on.</param>
    /// <param name="local">The animated pose in the parents' space; the joints are turned.</param>
    /// <param name="model">The same in model space; the joints and what hangs on them are brought up to date.</param>
    /// <exception cref="ArgumentException">The state is of another rig, a pose is not as long as the skeleton, or a number is not finite.</exception>
    public static void Update(SpringRig rig, SpringState state, in SpringSettings settings, in RootPlace root, ReadOnlySpan<SpringCollider> colliders, float seconds, in Pose local, in Pose model)
    {
        local.Require(rig.Skeleton);
        model.Require(rig.Skeleton);
        root.Require(nameof(root));
        Finite.RequireStep(seconds);
        if (!ReferenceEquals(state.Rig, rig))
        {
            throw new ArgumentException("the state was made for another rig; expected new SpringState(rig)", nameof(state));
        }

        ReadOnlySpan<int> joints = rig.Joints;
        if (joints.Length == 0)
        {
            return;
        }

        ReadAnimation(rig, state, root, model);
        ReadOnlySpan<SpringCollider> around = Place(colliders, state, root, model);
        if (!state.Started)
        {
            Start(rig, state, root);
        }
        else
        {
            state.Carry(root, IsJump(state.Root, root, settings, seconds) ? 0f : settings.Inertia);
        }

        if (seconds > LongestStep)
        {
            Resume(rig, state, settings, root, local);
        }
        else
        {
            Simulate(rig, state, settings, root, around, seconds, local);
        }

        Show(rig, state, settings, root, around, local, model);
        state.NowRotations.AsSpan().CopyTo(state.PastRotations);
        state.NowPositions.AsSpan().CopyTo(state.PastPositions);
    }

    private static bool IsJump(in RootPlace past, in RootPlace now, in SpringSettings settings, float seconds)
    {
        if (seconds > LongestStep || Vec.Distance(past.Position, now.Position) > settings.TeleportDistance)
        {
            return true;
        }

        return Rotation.Angle(Rotation.Multiply(Rotation.Inverse(past.Rotation), now.Rotation)) > settings.TeleportAngle;
    }

    private static void ReadAnimation(SpringRig rig, SpringState state, in RootPlace root, in Pose model)
    {
        float nought = 0f;
        for (int i = 0; i < rig.Joints.Length; i++)
        {
            int joint = rig.Joints[i];
            Quaternion q = Rotation.Multiply(root.Rotation, model.Rotations[joint]);
            Vector3 p = Rotation.Rotate(root.Rotation, model.Positions[joint]) * root.Scale;
            nought += ((q.X + q.Y + q.Z + q.W) + (p.X + p.Y + p.Z)) * 0f;
            state.NowRotations[i] = q;
            state.NowPositions[i] = p;
            if (nought != 0f)
            {
                throw PoseCheck.NotFinite(joint);
            }
        }
    }

    private static void Start(SpringRig rig, SpringState state, in RootPlace root)
    {
        state.Started = true;
        state.Root = root;
        state.Debt = 0f;
        state.NowRotations.AsSpan().CopyTo(state.PastRotations);
        state.NowPositions.AsSpan().CopyTo(state.PastPositions);
        for (int i = 0; i < rig.Joints.Length; i++)
        {
            state.Offsets[i] = Vector3.Zero;
            state.OffsetsBefore[i] = Vector3.Zero;
            state.Velocities[i] = Vector3.Zero;
            state.GoalVelocities[i] = Vector3.Zero;
            state.Goals[i] = state.NowPositions[i] + (Rotation.Rotate(state.NowRotations[i], rig.Tails[i]) * root.Scale);
        }
    }

    /// <summary>After a pause: shapes as they were, no velocities.</summary>
    private static void Resume(SpringRig rig, SpringState state, in SpringSettings settings, in RootPlace root, in Pose local)
    {
        float between = state.Debt / Substep;
        state.Debt = 0f;
        for (int i = 0; i < rig.Joints.Length; i++)
        {
            state.Velocities[i] = Vector3.Zero;
            state.GoalVelocities[i] = Vector3.Zero;
            state.Offsets[i] = Vec.Lerp(state.OffsetsBefore[i], state.Offsets[i], between);
            state.OffsetsBefore[i] = state.Offsets[i];
        }

        state.NowRotations.AsSpan().CopyTo(state.PastRotations);
        state.NowPositions.AsSpan().CopyTo(state.PastPositions);
        for (int i = 0; i < rig.Joints.Length; i++)
        {
            Quaternion goal = Goal(rig, state, i, 1f, settings.Inherit, root.Scale, local, out Vector3 place);
            Vector3 tail = Rotation.Rotate(goal, rig.Tails[i]) * root.Scale;
            state.Goals[i] = place + tail;
            state.Rotations[i] = Rotation.Multiply(Rotation.FromTo(tail, tail + state.Offsets[i]), goal);
        }
    }

    private static ReadOnlySpan<SpringCollider> Place(ReadOnlySpan<SpringCollider> colliders, SpringState state, in RootPlace root, in Pose model)
    {
        if (state.Colliders.Length < colliders.Length)
        {
            state.Colliders = new SpringCollider[colliders.Length];
        }

        for (int i = 0; i < colliders.Length; i++)
        {
            SpringCollider collider = colliders[i];
            if (collider.Joint >= model.Rotations.Length)
            {
                throw new ArgumentException(FormattableString.Invariant($"colliders[{i}] is carried by joint {collider.Joint}; expected 0 to {model.Rotations.Length - 1}, or −1"), nameof(colliders));
            }

            if (collider.Joint < 0)
            {
                bool plane = collider.Kind == SpringColliderKind.Plane;
                state.Colliders[i] = collider.Moved(collider.Start - root.Position, plane ? collider.End : collider.End - root.Position, collider.Radius);
                continue;
            }

            Quaternion turn = Rotation.Multiply(root.Rotation, model.Rotations[collider.Joint]);
            Vector3 place = Rotation.Rotate(root.Rotation, model.Positions[collider.Joint]) * root.Scale;
            state.Colliders[i] = collider.Moved(
                place + (Rotation.Rotate(turn, collider.Start) * root.Scale),
                place + (Rotation.Rotate(turn, collider.End) * root.Scale),
                collider.Radius * root.Scale);
        }

        return state.Colliders.AsSpan(0, colliders.Length);
    }

    private static void Simulate(SpringRig rig, SpringState state, in SpringSettings settings, in RootPlace root, ReadOnlySpan<SpringCollider> colliders, float seconds, in Pose local)
    {
        float debt = state.Debt + seconds;
        int steps = (int)(debt / Substep);
        if (steps > 0)
        {
            for (int i = 0; i < rig.Joints.Length; i++)
            {
                float along = rig.Along[i];
                float frequency = Math.Max(settings.Frequency.At(along), 0f);
                float ratio = Math.Max(settings.DampingRatio.At(along), 0f);
                if (frequency != state.Frequencies[i] || ratio != state.Ratios[i])
                {
                    state.Frequencies[i] = frequency;
                    state.Ratios[i] = ratio;
                    state.Steps[i] = new DampedSpring((float)(frequency * PortableMath.Tau), ratio, Substep);
                }
            }
        }

        float cosine = (float)PortableMath.Cos(settings.MostSwing);
        float sine = (float)PortableMath.Sin(settings.MostSwing);
        for (int k = 1; k <= steps; k++)
        {
            float share = seconds > 0f ? Math.Min(((k * Substep) - state.Debt) / seconds, 1f) : 1f;
            for (int i = 0; i < rig.Joints.Length; i++)
            {
                Advance(rig, state, settings, root.Scale, colliders, i, share, cosine, sine, local);
            }
        }

        state.Debt = Math.Max(debt - (steps * Substep), 0f);
    }

    /// <summary>One substep of one bone; its parent has made it already.</summary>
    private static void Advance(SpringRig rig, SpringState state, in SpringSettings settings, float scale, ReadOnlySpan<SpringCollider> colliders, int i, float share, float cosine, float sine, in Pose local)
    {
        Quaternion goalRotation = Goal(rig, state, i, share, settings.Inherit, scale, local, out Vector3 place);
        Vector3 tail = Rotation.Rotate(goalRotation, rig.Tails[i]) * scale;
        Vector3 goal = place + tail;
        Vector3 goalVelocity = (goal - state.Goals[i]) * (1f / Substep);
        ref readonly DampedSpring step = ref state.Steps[i];
        Vector3 offset = state.Offsets[i];
        Vector3 velocity = state.Velocities[i] + (state.GoalVelocities[i] - goalVelocity) + (settings.Gravity * Substep);
        Vector3 free = (offset * step.PlaceOfPlace) + (velocity * step.PlaceOfVelocity);
        velocity = (offset * step.VelocityOfPlace) + (velocity * step.VelocityOfVelocity);

        float length = Vec.Length(tail);
        Vector3 along = tail / length;
        Vector3 bone = InCone(tail + free, along, length, cosine, sine);
        if (colliders.Length > 0)
        {
            bone = Outside(colliders, place, bone, length, Math.Max(settings.Radius.At(rig.Along[i]), 0f) * scale);
        }

        Vector3 held = bone - tail;
        state.OffsetsBefore[i] = offset;
        state.Offsets[i] = held;
        state.Velocities[i] = velocity + ((held - free) * (1f / Substep));
        state.GoalVelocities[i] = goalVelocity;
        state.Goals[i] = goal;
        state.Rotations[i] = Rotation.Multiply(UnitTurn.FromTo(along, bone / length), goalRotation);
    }

    /// <summary>Where the animation would have a bone within the frame, with its parent as simulated.</summary>
    private static Quaternion Goal(SpringRig rig, SpringState state, int i, float share, float inherit, float scale, in Pose local, out Vector3 place)
    {
        Quaternion animated = share >= 1f ? state.NowRotations[i] : UnitTurn.Nlerp(state.PastRotations[i], state.NowRotations[i], share);
        state.Animated[i] = animated;
        int parent = rig.Parents[i];
        if (parent < 0)
        {
            place = Vec.Lerp(state.PastPositions[i], state.NowPositions[i], share);
            state.Positions[i] = place;
            return animated;
        }

        place = state.Positions[parent] + (Rotation.Rotate(state.Rotations[parent], local.Positions[rig.Joints[i]]) * scale);
        state.Positions[i] = place;
        Quaternion deviation = Rotation.Multiply(state.Rotations[parent], Rotation.Inverse(state.Animated[parent]));
        return Rotation.Multiply(UnitTurn.Nlerp(Quaternion.Identity, deviation, inherit), animated);
    }

    /// <summary>A bone of the right length whose direction is no farther from another than the cone allows.</summary>
    private static Vector3 InCone(Vector3 bone, Vector3 axis, float length, float cosine, float sine)
    {
        Vector3 direction = Vec.Normalize(bone, axis);
        if (Vec.Dot(direction, axis) >= cosine)
        {
            return direction * length;
        }

        Vector3 across = Vec.Normalize(Vec.Reject(direction, axis), Vec.Perpendicular(axis));
        return ((axis * cosine) + (across * sine)) * length;
    }

    private static Vector3 Outside(ReadOnlySpan<SpringCollider> colliders, Vector3 place, Vector3 bone, float length, float radius)
    {
        for (int round = 0; round < CollisionRounds; round++)
        {
            for (int c = 0; c < colliders.Length; c++)
            {
                bone = colliders[c].Turn(place, bone, length, radius);
            }
        }

        // Between a body and the ground, the ground wins.
        for (int c = 0; c < colliders.Length; c++)
        {
            if (colliders[c].Kind == SpringColliderKind.Plane)
            {
                bone = colliders[c].Turn(place, bone, length, radius);
            }
        }

        return bone;
    }

    /// <summary>Poses the joints for the moment of the frame.</summary>
    private static void Show(SpringRig rig, SpringState state, in SpringSettings settings, in RootPlace root, ReadOnlySpan<SpringCollider> colliders, in Pose local, in Pose model)
    {
        float between = state.Debt / Substep;
        Quaternion toModel = Rotation.Inverse(root.Rotation);
        for (int i = 0; i < rig.Joints.Length; i++)
        {
            Quaternion goal = Goal(rig, state, i, 1f, settings.Inherit, root.Scale, local, out Vector3 place);
            Vector3 tail = Rotation.Rotate(goal, rig.Tails[i]) * root.Scale;
            Vector3 bone = tail + Vec.Lerp(state.OffsetsBefore[i], state.Offsets[i], between);
            float length = Vec.Length(tail);
            Vector3 along = tail / length;
            Vector3 direction = Vec.Normalize(bone, along);
            if (colliders.Length > 0)
            {
                direction = Outside(colliders, place, direction * length, length, Math.Max(settings.Radius.At(rig.Along[i]), 0f) * root.Scale) / length;
            }

            state.Rotations[i] = Rotation.Multiply(UnitTurn.FromTo(along, direction), goal);
            int joint = rig.Joints[i];
            Quaternion shown = settings.Weight < 1f ? Rotation.Slerp(state.NowRotations[i], state.Rotations[i], settings.Weight) : state.Rotations[i];
            Quaternion inModel = Rotation.Multiply(toModel, shown);
            local.Rotations[joint] = Rotation.Normalize(Rotation.Multiply(JointRelations.ParentInverse(rig.Skeleton, joint, model), inModel));
            Subtree.Place(rig.Skeleton.Parents[joint], joint, local, model);
        }

        for (int i = 0; i < rig.Joints.Length; i++)
        {
            if (rig.Parents[i] < 0)
            {
                Subtree.LocalToModel(rig.Skeleton, rig.Joints[i], local, model);
            }
        }
    }
}
