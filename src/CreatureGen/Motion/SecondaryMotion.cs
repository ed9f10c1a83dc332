using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Subjects;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Springs;
using CreatureGen.Rigging;

namespace CreatureGen.Motion;

/// <summary>What swings after the motion by itself: tail, ears, feelers; never into the ground.</summary>
internal sealed class SecondaryMotion
{
    /// <summary>Part of its length that a chain keeps from the ground at the least.</summary>
    private const float Thickness = 0.03f;

    /// <summary>Part of a joint's limit that its spring may take up.</summary>
    private const float SwingFraction = 0.38f;

    private readonly SwingingChain[] chains;
    private readonly SpringState[] states;
    private readonly SpringCollider[] ground = new SpringCollider[1];

    public SecondaryMotion(SwingingChain[] chains)
    {
        this.chains = chains;
        states = new SpringState[chains.Length];
        for (int i = 0; i < chains.Length; i++)
        {
            // Room for colliders is made now, so that no update has to.
            states[i] = new SpringState(chains[i].Rig) { Colliders = new SpringCollider[ground.Length] };
        }
    }

    /// <summary>Asks memory for what is remembered of each chain.</summary>
    /// <returns>See <see cref="MemoryLines"/>.</returns>
    public int Fetch()
    {
        int read = 0;
        for (int i = 0; i < chains.Length; i++)
        {
            read ^= states[i].Fetch();
        }

        return read;
    }

    /// <summary>The chains of a skeleton that swing, and how.</summary>
    public static SwingingChain[] Of(MotionSubject subject, bool tail)
    {
        Skeleton skeleton = subject.Skeleton;
        var chains = new List<SwingingChain>();
        Add(JointRole.Tail, tail);
        Add(JointRole.Ear, true);
        Add(JointRole.Antenna, true);
        return chains.ToArray();

        void Add(JointRole role, bool wanted)
        {
            SpringRig rig = SpringRig.Of(skeleton, role);
            if (wanted && rig.Joints.Length > 0 && rig.Length > 0f)
            {
                SpringSettings free = role switch { JointRole.Tail => SpringSettings.Tail(rig.Length), JointRole.Ear => SpringSettings.Ear(rig.Length), _ => SpringSettings.Antenna(rig.Length) };
                chains.Add(new SwingingChain(rig, Within(free, rig, SkinBelow(subject, rig))));
            }
        }
    }

    /// <summary>Turns the joints that swing.</summary>
    /// <param name="root">Where the creature is.</param>
    /// <param name="clearance">Height of the root above the ground, metres of the model; infinite where there is none.</param>
    /// <param name="rise">How the ground goes on along the body, metres up for each metre ahead.</param>
    /// <param name="balanced">The push to the side that the lean of the body balances, m/s², world space.</param>
    /// <param name="seconds">Since the last update.</param>
    /// <param name="local">Receives the rotations.</param>
    /// <param name="model">Receives what follows from them.</param>
    public void Update(in RootPlace root, float clearance, float rise, Vector3 balanced, float seconds, in Pose local, in Pose model)
    {
        Vector3 up = Rotation.Rotate(root.Rotation, Vector3.UnitY);
        Vector3 normal = rise == 0f ? up : Rotation.Rotate(root.Rotation, Vec.Normalize(new Vector3(0f, 1f, -rise), Vector3.UnitY));
        for (int i = 0; i < chains.Length; i++)
        {
            SwingingChain chain = chains[i];
            SpringRig rig = chain.Rig;
            ReadOnlySpan<SpringCollider> colliders = ReadOnlySpan<SpringCollider>.Empty;
            float height = (Thickness * rig.Length) - clearance;
            if (ReachesDown(rig, clearance, rise, model))
            {
                ground[0] = SpringCollider.Plane(root.Position + (up * (height * root.Scale)), normal);
                colliders = ground;
            }

            SpringBones.Update(rig, states[i], chain.Settings, chain.Tuning, balanced, root, colliders, seconds, local, model);
            if (KeepWithinLimits(rig, local, model) && colliders.Length > 0)
            {
                ChainLift.Raise(rig, height, rise, chain.Settings.Radius, local, model);
            }
        }
    }

    /// <summary>Forgets all swing: the creature has been put somewhere else.</summary>
    public void Reset()
    {
        foreach (SpringState state in states)
        {
            state.Reset();
        }
    }

    /// <summary>Moves the origin of the world.</summary>
    public void Rebase(Vector3 offset)
    {
        foreach (SpringState state in states)
        {
            state.Rebase(offset);
        }
    }

    /// <summary>Brings joints back to their limits; whether one was beyond.</summary>
    private static bool KeepWithinLimits(SpringRig rig, in Pose local, in Pose model)
    {
        int first = -1;
        foreach (ref readonly SpringJoint bone in rig.Bones)
        {
            int joint = bone.Joint;
            Quaternion turn = local.Rotations[joint];
            Quaternion bounded = bone.Limit.Clamp(turn);
            if (bounded != turn)
            {
                local.Rotations[joint] = bounded;
                first = first < 0 ? joint : first;
            }
        }

        if (first >= 0)
        {
            Subtree.LocalToModel(rig.Skeleton, first, local, model);
        }

        return first >= 0;
    }

    /// <summary>Whether a chain is as near to the ground as it is long.</summary>
    private static bool ReachesDown(SpringRig rig, float clearance, float rise, in Pose model)
    {
        float length = (1f + Thickness + Math.Abs(rise)) * rig.Length;
        foreach (int root in rig.Roots)
        {
            if (model.Positions[root].Y + clearance - (rise * model.Positions[root].Z) < length)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>How far the skin of each bone is below it, beyond what all of the chain keeps from the ground.</summary>
    private static ChainCurve SkinBelow(MotionSubject subject, SpringRig rig)
    {
        SpringJoint[] bones = rig.Bones.ToArray();
        float[] below = BoneSkin.Below(subject, rig.Joints, Array.ConvertAll(bones, bone => bone.Direction), Array.ConvertAll(bones, bone => bone.Length));
        var depths = new SortedDictionary<float, float>();
        for (int i = 0; i < below.Length; i++)
        {
            depths.TryGetValue(rig.Places[i], out float depth);
            depths[rig.Places[i]] = Math.Max(depth, below[i] - (Thickness * rig.Length));
        }

        return ChainCurve.Through(depths.Keys.ToArray(), depths.Values.ToArray());
    }

    /// <summary>Settings whose swing leaves room for the motion within the narrowest joint's limits.</summary>
    private static SpringSettings Within(in SpringSettings settings, SpringRig rig, ChainCurve radius)
    {
        float max = settings.MaxSwing;
        foreach (int joint in rig.Joints)
        {
            JointLimit limit = rig.Skeleton.Joints[joint].Limit;
            float min = Math.Min(Math.Min(-limit.SwingX.Min, limit.SwingX.Max), Math.Min(-limit.SwingZ.Min, limit.SwingZ.Max));
            max = Math.Min(max, Math.Max(SwingFraction * min, 0.02f));
        }

        return new SpringSettings(settings.Frequency, settings.DampingRatio, radius, settings.Gravity, max, settings.Inherit, settings.Inertia, settings.Weight, settings.TeleportDistance, settings.TeleportAngle, settings.MaxSpeed);
    }
}
