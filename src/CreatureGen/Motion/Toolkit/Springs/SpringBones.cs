using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Poses;
using CreatureGen.Motion.Toolkit.Springs;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Lets tails, ears, feelers and the like swing after any motion. Nothing is allocated once the colliders have been seen.</summary>
/// <remarks>
/// <para>Each bone's tip hangs on a spring at its goal, which is where the animated pose of this very frame would have it, its parent's swing taken over by a share. The spring is stepped at 120 Hz, whatever the frame
/// rate, by its exact solution (<see cref="DampedSpring"/>), relative to the velocity of its goal: x″ = ω²(goal − x) − 2ζω(x′ − goal′) + gravity. A damping relative to the world would bend tails back when running.
/// Then the tip is brought into a cone about its goal, the whole bone as a capsule out of the colliders, and the tip back to the length of its bone; the correction changes the velocity by itself over the step. The bone is turned by the
/// smallest rotation that points it at the tip.</para>
/// <para>The animated pose is interpolated within the frame for the substeps; for time left over after the last of them, part of the step is taken that would follow if the goals went on as they do. So nothing lags, and nothing trembles at
/// frame rates that are no divisor of 120 Hz.</para>
/// <para>Based on: T. Jakobsen, "Advanced character physics" (2001), for projection; M. Müller et al., "Position based dynamics" (2007), for the velocity; VRM's spring bones for goals, tips and centre space.</para>
/// </remarks>
public static class SpringBones
{
    /// <summary>Length of a substep, seconds.</summary>
    public const float Substep = 1f / 120f;

    /// <summary>A step longer than this is a pause, not motion: shapes are kept and nothing is simulated. Seconds.</summary>
    public const float LongestStep = 0.25f;

    private const int CollisionRounds = 2;

    /// <summary>Part of a substep below which a goal's velocity cannot be told from what it has gone.</summary>
    private const float MinFraction = 1e-3f;

    /// <summary>Substeps that are made of one bone before the next, and the moment of the frame.</summary>
    private const int MaxMoments = 5;

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
        Update(rig, state, settings, state.Tune(settings), settings.Gravity, root, colliders, seconds, local, model);
    }

    /// <summary>The same under another acceleration than the settings have, with what has been worked out for them.</summary>
    internal static void Update(SpringRig rig, SpringState state, in SpringSettings settings, SpringTuning tuning, Vector3 gravity, in RootPlace root, ReadOnlySpan<SpringCollider> colliders, float seconds, in Pose local, in Pose model)
    {
        local.Require(rig.Skeleton);
        model.Require(rig.Skeleton);
        root.Require(nameof(root));
        Finite.RequireStep(seconds);
        if (!ReferenceEquals(state.Rig, rig))
        {
            throw new ArgumentException("the state was made for another rig; expected new SpringState(rig)", nameof(state));
        }

        if (rig.Joints.Length == 0)
        {
            return;
        }

        state.Gravity = gravity;
        Span<SpringAim> now = stackalloc SpringAim[rig.Joints.Length];
        ReadModelPose(rig, now, root, model);
        ReadOnlySpan<SpringCollider> around = Place(colliders, state, root, model);
        if (!state.Started)
        {
            state.Start(root, now);
        }
        else
        {
            state.Carry(root, IsJump(state.Root, root, settings, seconds) ? 0f : settings.Inertia);
        }

        Simulate(rig, state, settings, tuning, root, around, seconds, now, local, model);
    }

    private static bool IsJump(in RootPlace past, in RootPlace now, in SpringSettings settings, float seconds)
    {
        if (seconds > LongestStep || Vec.Distance(past.Position, now.Position) > settings.TeleportDistance)
        {
            return true;
        }

        // Most turns are told from a jump without their angle: up to a right angle it is less than three times the sine of its half.
        Quaternion turn = Rotation.Multiply(Rotation.Inverse(past.Rotation), now.Rotation);
        float sine = (turn.X * turn.X) + (turn.Y * turn.Y) + (turn.Z * turn.Z);
        bool small = sine < 0.5f && 9f * sine < settings.TeleportAngle * settings.TeleportAngle;
        return !small && Rotation.Angle(turn) > settings.TeleportAngle;
    }

    private static void ReadModelPose(SpringRig rig, Span<SpringAim> now, in RootPlace root, in Pose model)
    {
        float nought = 0f;
        ReadOnlySpan<SpringJoint> joints = rig.Bones;
        for (int i = 0; i < joints.Length; i++)
        {
            int joint = joints[i].Joint;
            Vector3 p = Vec.Scale(Rotation.Rotate(root.Rotation, model.Positions[joint]), root.Scale);
            Vector3 own = joints[i].Direction;
            Vector3 inModel = own == Vector3.UnitY ? UnitRotation.BoneAxis(model.Rotations[joint]) : Rotation.Rotate(model.Rotations[joint], own);
            Vector3 along = Rotation.Rotate(root.Rotation, inModel);
            nought += ((along.X + along.Y + along.Z) + (p.X + p.Y + p.Z)) * 0f;
            now[i].Position = p;
            now[i].Along = along;
            if (nought != 0f)
            {
                throw PoseCheck.NotFinite(joint);
            }
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

    /// <summary>Makes the substeps that are due, and poses the joints for the moment of the frame.</summary>
    private static void Simulate(SpringRig rig, SpringState state, in SpringSettings settings, SpringTuning tuning, in RootPlace root, ReadOnlySpan<SpringCollider> colliders, float seconds, ReadOnlySpan<SpringAim> now, in Pose local, in Pose model)
    {
        bool pause = seconds > LongestStep;
        if (pause)
        {
            state.Rest(now);
            seconds = 0f;
        }

        float debt = state.Debt + seconds;
        int steps = (int)(debt / Substep);
        int stride = Math.Min(steps, MaxMoments - 1) + 1;
        Span<SpringMoment> moments = stackalloc SpringMoment[rig.Joints.Length * stride];
        Span<float> fractions = stackalloc float[MaxMoments];
        float left = Math.Max(debt - (steps * Substep), 0f);
        int done = 0;
        do
        {
            int count = Math.Min(steps - done, MaxMoments - 1);
            for (int k = 0; k < count; k++)
            {
                fractions[k] = seconds > 0f ? Math.Min((((done + k + 1) * Substep) - state.Debt) / seconds, 1f) : 1f;
            }

            done += count;
            if (done < steps)
            {
                for (int i = 0; i < rig.Joints.Length; i++)
                {
                    Advance(rig, state, settings, tuning, root.Scale, colliders, i, now[i], fractions.Slice(0, count), moments, stride);
                }
            }
            else
            {
                // A substep that ends with the frame is what is shown.
                state.Debt = left;
                bool between = left > 0f || count == 0;
                int shown = between ? stride - 1 : count - 1;
                for (int i = 0; i < rig.Joints.Length; i++)
                {
                    Advance(rig, state, settings, tuning, root.Scale, colliders, i, now[i], fractions.Slice(0, count), moments, stride);
                    if (between)
                    {
                        Vector3 goal = Foresee(rig, state, settings, tuning, root.Scale, colliders, i, now[i], moments, stride);
                        if (pause)
                        {
                            // No way was gone to it.
                            state.Bones[i].Goal = goal;
                        }
                    }

                    state.Bones[i].Past = now[i];
                    Show(rig, settings, root, i, moments[(i * stride) + shown].Deviation, local, model);
                }
            }
        }
        while (done < steps);

        ReadOnlySpan<int> parents = rig.Skeleton.Parents;
        foreach (int joint in rig.Ends)
        {
            Subtree.Place(parents[joint], joint, local, model);
        }
    }

    /// <summary>Some substeps of one bone; its parent has made them already. One bone after the other, not one step after the other: a step waits for little of the one before, but a bone for all of its parent.</summary>
    private static void Advance(SpringRig rig, SpringState state, in SpringSettings settings, SpringTuning tuning, float scale, ReadOnlySpan<SpringCollider> colliders, int index, in SpringAim now, ReadOnlySpan<float> fractions, Span<SpringMoment> moments, int stride)
    {
        const float PerSecond = 1f / Substep;
        ref readonly SpringJoint joint = ref rig.Bones[index];
        int parent = joint.Parent;
        float length = joint.Length * scale;
        float width = length * tuning.Width;
        ref readonly SpringTone tone = ref tuning.Bones[index];
        ref SpringBone bone = ref state.Bones[index];
        float radius = tone.Radius * scale;
        Vector3 push = Vec.Scale(state.Gravity, Substep * tone.GravityFraction);
        DampedSpring step = tone.Step;
        for (int k = 0; k < fractions.Length; k++)
        {
            float fraction = fractions[k];
            ref SpringMoment moment = ref moments[(index * stride) + k];
            Vector3 animated = fraction >= 1f ? now.Along : Vec.Normalize(Vec.Lerp(bone.Past.Along, now.Along, fraction), now.Along);
            moment.Animated = Vec.Lerp(bone.Past.Position, now.Position, fraction);
            Quaternion carried = Carried(ref moment, moments, (parent * stride) + k, settings.Inherit, out float squared);
            Vector3 along = SimdKernels.RotateByAny(carried, squared, animated);
            Vector3 tail = Vec.Scale(along, length);
            Vector3 goal = moment.Place + tail;
            Vector3 goalVelocity = Vec.Scale(goal - bone.Goal, PerSecond);
            Vector3 offset = bone.Offset;
            Vector3 velocity = Driven(bone, tone.Liveliness, goalVelocity, push, width);
            velocity = tone.Slowed < 1f ? Blown(velocity, goalVelocity, settings.Wind, tone.Slowed) : velocity;
            Vector3 free = Vec.Scale(offset, step.PlaceOfPlace) + Vec.Scale(velocity, step.PlaceOfVelocity);
            velocity = Vec.Scale(offset, step.VelocityOfPlace) + Vec.Scale(velocity, step.VelocityOfVelocity);
            Vector3 direction = InCone(Vec.Normalize(tail + free, along), along, tuning.SwingCosine, tuning.SwingSine);
            direction = Outside(colliders, moment.Place, direction, length, radius);
            Vector3 held = Vec.Scale(direction, length) - tail;
            bone.Offset = held;
            bone.Velocity = velocity + Vec.Scale(held - free, PerSecond);
            bone.GoalVelocity = goalVelocity;
            bone.Goal = goal;
            moment.Deviation = Turned(carried, squared, along, direction);
        }
    }

    /// <summary>Finds how a bone is at the moment of the frame, after the last substep and before the next; its parent has been found already.</summary>
    /// <returns>The goal of its tip at that moment.</returns>
    private static Vector3 Foresee(SpringRig rig, SpringState state, in SpringSettings settings, SpringTuning tuning, float scale, ReadOnlySpan<SpringCollider> colliders, int index, in SpringAim now, Span<SpringMoment> moments, int stride)
    {
        ref readonly SpringJoint joint = ref rig.Bones[index];
        float length = joint.Length * scale;
        ref readonly SpringTone tone = ref tuning.Bones[index];
        ref SpringBone bone = ref state.Bones[index];
        ref SpringMoment moment = ref moments[(index * stride) + stride - 1];
        moment.Animated = now.Position;
        Quaternion carried = Carried(ref moment, moments, (joint.Parent * stride) + stride - 1, settings.Inherit, out float squared);
        Vector3 along = SimdKernels.RotateByAny(carried, squared, now.Along);
        Vector3 tail = Vec.Scale(along, length);
        Vector3 goal = moment.Place + tail;
        float fraction = state.Debt / Substep;
        Vector3 goalVelocity = fraction > MinFraction ? (goal - bone.Goal) / state.Debt : bone.GoalVelocity;
        Vector3 velocity = Driven(bone, tone.Liveliness, goalVelocity, Vec.Scale(state.Gravity, Substep * tone.GravityFraction), length * tuning.Width);
        velocity = tone.Slowed < 1f ? Blown(velocity, goalVelocity, settings.Wind, tone.Slowed) : velocity;
        Vector3 free = Vec.Lerp(bone.Offset, Vec.Scale(bone.Offset, tone.Step.PlaceOfPlace) + Vec.Scale(velocity, tone.Step.PlaceOfVelocity), fraction);
        Vector3 direction = InCone(Vec.Normalize(tail + free, along), along, tuning.SwingCosine, tuning.SwingSine);
        direction = Outside(colliders, moment.Place, direction, length, tone.Radius * scale);
        bone.OffsetShown = Vec.Scale(direction, length) - tail;
        moment.Deviation = Turned(carried, squared, along, direction);
        return goal;
    }

    /// <summary>Poses a joint by its deviation from the animation; its parent is posed already.</summary>
    private static void Show(SpringRig rig, in SpringSettings settings, in RootPlace root, int index, Quaternion deviation, in Pose local, in Pose model)
    {
        Quaternion shown = settings.Weight < 1f ? Rotation.Slerp(Quaternion.Identity, deviation, settings.Weight) : deviation;
        int joint = rig.Bones[index].Joint;
        Quaternion turn = Rotation.Multiply(Rotation.Inverse(root.Rotation), Rotation.Multiply(shown, root.Rotation));
        Quaternion inModel = UnitRotation.Renormalize(Rotation.Multiply(turn, model.Rotations[joint]));
        int parent = rig.Bones[index].Carrier;
        model.Rotations[joint] = inModel;
        if (parent < 0)
        {
            local.Rotations[joint] = inModel;
            return;
        }

        Quaternion carrier = model.Rotations[parent];
        local.Rotations[joint] = Rotation.Multiply(Rotation.Inverse(carrier), inModel);
        model.Positions[joint] = model.Positions[parent] + Rotation.Rotate(carrier, local.Positions[joint]);
    }

    /// <summary>How far a bone is carried along by its parent's deviation from the animation, not brought to unit length, with the square of that length; and its place.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Quaternion Carried(ref SpringMoment moment, ReadOnlySpan<SpringMoment> moments, int parent, float inherit, out float squared)
    {
        if (parent < 0)
        {
            moment.Place = moment.Animated;
            squared = 1f;
            return Quaternion.Identity;
        }

        ref readonly SpringMoment carrier = ref moments[parent];
        Quaternion deviation = carrier.Deviation;
        moment.Place = carrier.Place + Rotation.Rotate(deviation, moment.Animated - carrier.Animated);

        // Of a mix of the identity and a unit quaternion: their product is the w of that.
        squared = 1f - (2f * inherit * (1f - inherit) * (1f - Math.Abs(deviation.W)));
        return SimdKernels.Mix(Quaternion.Identity, 1f - inherit, deviation, deviation.W < 0f ? -inherit : inherit);
    }

    /// <summary>A turn of any length followed by the smallest one that takes one unit vector to another, brought to unit length.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Quaternion Turned(Quaternion carried, float squared, Vector3 along, Vector3 direction)
    {
        Quaternion turn = UnitRotation.Between(along, direction, out float square);
        return SimdKernels.Scale(Rotation.Multiply(turn, carried), 1f / MathF.Sqrt(square * squared));
    }

    /// <summary>Velocity of a tip relative to its goal as a substep begins: no greater than that of a free swing of full width at its offset.</summary>
    /// <param name="bone">After the substep before.</param>
    /// <param name="liveliness">See <see cref="SpringTone.Liveliness"/>.</param>
    /// <param name="goalVelocity">Of the goal in this one.</param>
    /// <param name="push">Velocity that gravity adds.</param>
    /// <param name="width">The greatest offset.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector3 Driven(in SpringBone bone, float liveliness, Vector3 goalVelocity, Vector3 push, float width)
    {
        Vector3 velocity = bone.Velocity + (bone.GoalVelocity - goalVelocity) + push;
        if (float.IsPositiveInfinity(liveliness))
        {
            return velocity;
        }

        float max = liveliness * Math.Max((width * width) - Vec.LengthSquared(bone.Offset), 0f);
        float squared = Vec.LengthSquared(velocity);
        return squared > max ? Vec.Scale(velocity, MathF.Sqrt(max / squared)) : velocity;
    }

    /// <summary>Velocity relative to the goal after the air has taken its part of a substep.</summary>
    private static Vector3 Blown(Vector3 velocity, Vector3 goalVelocity, Vector3 wind, float left)
    {
        Vector3 air = wind - goalVelocity;
        return air + ((velocity - air) * left);
    }

    /// <summary>A direction no farther from another than the cone allows.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector3 InCone(Vector3 direction, Vector3 axis, float cosine, float sine)
    {
        if (Vec.Dot(direction, axis) >= cosine)
        {
            return direction;
        }

        Vector3 across = Vec.Normalize(Vec.Reject(direction, axis), Vec.Perpendicular(axis));
        return Vec.Scale(axis, cosine) + Vec.Scale(across, sine);
    }

    /// <summary>A direction of a bone that brings it out of all colliders.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector3 Outside(ReadOnlySpan<SpringCollider> colliders, Vector3 place, Vector3 direction, float length, float radius)
    {
        if (colliders.Length == 0)
        {
            return direction;
        }

        Vector3 bone = Vec.Scale(direction, length);
        return colliders.Length == 1 && colliders[0].Clears(place, bone, radius) ? direction : TurnOut(colliders, place, bone, length, radius);
    }

    private static Vector3 TurnOut(ReadOnlySpan<SpringCollider> colliders, Vector3 place, Vector3 bone, float length, float radius)
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

        return bone / length;
    }
}
