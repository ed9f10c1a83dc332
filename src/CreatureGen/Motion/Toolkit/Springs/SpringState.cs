using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Springs;

namespace CreatureGen.Motion.Toolkit;

/// <summary>
/// What spring bones remember from frame to frame. Made once per creature and rig; everything is kept relative to the creature's place, so that the world's origin may be anywhere and may be moved.
/// </summary>
public sealed class SpringState
{
    private SpringTuning? tuning;
    private RootPlace root;

    /// <summary>Starts at rest: the first update takes the animated pose as it is.</summary>
    public SpringState(SpringRig rig)
    {
        Rig = rig;
        Bones = new SpringBone[rig.Joints.Length];
        Colliders = Array.Empty<SpringCollider>();
    }

    internal SpringRig Rig { get; }

    /// <summary>Whether the fields below mean anything.</summary>
    internal bool Started { get; set; }

    /// <summary>Time not yet simulated, seconds, less than one substep.</summary>
    internal float Debt { get; set; }

    /// <summary>Where the creature was.</summary>
    internal RootPlace Root
    {
        get => root;
        set => root = value;
    }

    /// <summary>Acceleration in the world that the bones feel in this update, m/s².</summary>
    internal Vector3 Gravity { get; set; }

    /// <summary>What is remembered of each joint of the rig, in its order.</summary>
    internal SpringBone[] Bones { get; }

    /// <summary>Colliders from the creature's place, world axes; grows to the most that were ever given.</summary>
    internal SpringCollider[] Colliders { get; set; }

    /// <summary>Asks memory for what is remembered.</summary>
    /// <returns>See <see cref="MemoryLines"/>.</returns>
    internal int Fetch() => MemoryLines.Touch(ref root) ^ MemoryLines.Touch(Bones, Rig.Bones.Length);

    /// <summary>Forgets all motion: the next update takes the animated pose as it is.</summary>
    public void Reset() => Started = false;

    /// <summary>Tells the springs that the world's origin was moved, so that all positions changed by an offset and nothing else did.</summary>
    /// <param name="offset">Added to every position of the world, metres.</param>
    /// <exception cref="System.ArgumentException">The offset is not finite.</exception>
    public void Rebase(Vector3 offset)
    {
        Finite.Require(offset, nameof(offset));
        if (Started)
        {
            Root = new RootPlace(Root.Position + offset, Root.Rotation, Root.Scale);
        }
    }

    /// <summary>Tells the springs that the creature was put elsewhere: its hanging parts keep their shape and their motion relative to it.</summary>
    /// <param name="root">Where it is now.</param>
    public void Teleport(in RootPlace root)
    {
        root.Require(nameof(root));
        if (Started)
        {
            Carry(root, 0f);
        }
    }

    /// <summary>Works out the springs anew if the settings are not those they were worked out for.</summary>
    internal SpringTuning Tune(in SpringSettings settings)
    {
        if (tuning == null)
        {
            tuning = new SpringTuning(Rig, settings);
        }
        else if (!tuning.Is(settings))
        {
            tuning.Take(settings);
        }

        return tuning;
    }

    /// <summary>Takes the pose for what always was.</summary>
    internal void Start(in RootPlace root, ReadOnlySpan<SpringAim> now)
    {
        Started = true;
        Root = root;
        Debt = 0f;
        for (int i = 0; i < Bones.Length; i++)
        {
            Bones[i] = new SpringBone { Goal = now[i].Position + (now[i].Along * (Rig.Bones[i].Length * root.Scale)), Past = now[i] };
        }
    }

    /// <summary>After a pause: shapes as they were shown, no velocities, and no way from where the animation was.</summary>
    internal void Rest(ReadOnlySpan<SpringAim> now)
    {
        bool between = Debt > 0f;
        Debt = 0f;
        for (int i = 0; i < Bones.Length; i++)
        {
            ref SpringBone bone = ref Bones[i];
            bone.Offset = between ? bone.OffsetShown : bone.Offset;
            bone.Velocity = Vector3.Zero;
            bone.GoalVelocity = Vector3.Zero;
            bone.Past = now[i];
        }
    }

    /// <summary>Goes over to a new place, as if the creature had only moved and turned by a share of the way.</summary>
    internal void Carry(in RootPlace root, float felt)
    {
        float grown = root.Scale / Root.Scale;
        Vector3 shift = (root.Position - Root.Position) * felt;
        if (felt >= 1f && grown == 1f)
        {
            for (int i = 0; i < Bones.Length; i++)
            {
                ref SpringBone bone = ref Bones[i];
                bone.Goal -= shift;
                bone.Past.Position -= shift;
            }

            Root = root;
            return;
        }

        Quaternion turn = Rotation.Multiply(root.Rotation, Rotation.Inverse(Root.Rotation));
        Quaternion silent = felt < 1f ? Rotation.Slerp(Quaternion.Identity, turn, 1 - felt) : Quaternion.Identity;
        for (int i = 0; i < Bones.Length; i++)
        {
            ref SpringBone bone = ref Bones[i];
            bone.Offset = Rotation.Rotate(silent, bone.Offset) * grown;
            bone.OffsetShown = Rotation.Rotate(silent, bone.OffsetShown) * grown;
            bone.Velocity = Rotation.Rotate(silent, bone.Velocity) * grown;
            bone.GoalVelocity = Rotation.Rotate(silent, bone.GoalVelocity) * grown;
            bone.Goal = (Rotation.Rotate(silent, bone.Goal) * grown) - shift;
            bone.Past.Position = (Rotation.Rotate(silent, bone.Past.Position) * grown) - shift;
            bone.Past.Along = Rotation.Rotate(silent, bone.Past.Along);
        }

        Root = root;
    }
}
