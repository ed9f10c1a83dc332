using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Springs;

namespace CreatureGen.Motion.Toolkit;

/// <summary>
/// What spring bones remember from frame to frame. Made once per creature and rig; everything is kept relative to the creature's place, so that the world's origin may be anywhere and may be moved.
/// </summary>
public sealed class SpringState
{
    private ChainCurve frequency;
    private ChainCurve ratio;
    private ChainCurve radius;
    private ChainCurve drag;
    private ChainCurve fraction;
    private float swing;
    private float speed;
    private bool tuned;

    /// <summary>Starts at rest: the first update takes the animated pose as it is.</summary>
    public SpringState(SpringRig rig)
    {
        Rig = rig;
        Bones = new SpringBone[rig.Joints.Length];
        Colliders = System.Array.Empty<SpringCollider>();
    }

    internal SpringRig Rig { get; }

    /// <summary>Whether the fields below mean anything.</summary>
    internal bool Started { get; set; }

    /// <summary>Time not yet simulated, seconds, less than one substep.</summary>
    internal float Debt { get; set; }

    /// <summary>Where the creature was.</summary>
    internal RootPlace Root { get; set; }

    /// <summary>Acceleration in the world that the bones feel in this update, m/s².</summary>
    internal Vector3 Gravity { get; set; }

    /// <summary>What is remembered of each joint of the rig, in its order.</summary>
    internal SpringBone[] Bones { get; }

    /// <summary>Cosine of the most that a bone swings from its goal.</summary>
    internal float SwingCosine { get; private set; }

    /// <summary>Its sine.</summary>
    internal float SwingSine { get; private set; }

    /// <summary>The greatest offset of a tip from its goal, lengths of its bone.</summary>
    internal float Width { get; private set; }

    /// <summary>Colliders from the creature's place, world axes; grows to the most that were ever given.</summary>
    internal SpringCollider[] Colliders { get; set; }

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
    internal void Tune(in SpringSettings settings)
    {
        bool air = drag.Is(settings.Drag) && fraction.Is(settings.GravityFraction);
        if (tuned && air && radius.Is(settings.Radius) && frequency.Is(settings.Frequency) && ratio.Is(settings.DampingRatio) && swing == settings.MaxSwing && speed == settings.MaxSpeed)
        {
            return;
        }

        tuned = true;
        frequency = settings.Frequency;
        ratio = settings.DampingRatio;
        radius = settings.Radius;
        drag = settings.Drag;
        fraction = settings.GravityFraction;
        swing = settings.MaxSwing;
        speed = settings.MaxSpeed;
        PortableMath.SinCos(swing, out double sine, out double cosine);
        SwingSine = (float)sine;
        SwingCosine = (float)cosine;
        Width = (float)System.Math.Sqrt(2 * (1 - cosine));
        for (int i = 0; i < Bones.Length; i++)
        {
            float along = Rig.Places[i];
            float cycles = System.Math.Max(frequency.At(along), 0f);
            double fastest = cycles * PortableMath.Tau * speed;
            Bones[i].Liveliness = cycles > 0f && fastest < 1e9 ? (float)(fastest * fastest) : float.PositiveInfinity;
            Bones[i].Slowed = Damping.Left(System.Math.Max(drag.At(along), 0f), SpringBones.Substep);
            Bones[i].GravityFraction = fraction.At(along);
            Bones[i].Radius = System.Math.Max(radius.At(along), 0f);
            Bones[i].Step = new DampedSpring((float)(cycles * PortableMath.Tau), System.Math.Max(ratio.At(along), 0f), SpringBones.Substep);
        }
    }

    /// <summary>After a pause: shapes as they were shown, no velocities.</summary>
    internal void Rest()
    {
        bool between = Debt > 0f;
        Debt = 0f;
        for (int i = 0; i < Bones.Length; i++)
        {
            ref SpringBone bone = ref Bones[i];
            bone.Offset = between ? bone.OffsetShown : bone.Offset;
            bone.Velocity = Vector3.Zero;
            bone.GoalVelocity = Vector3.Zero;
            bone.PastPosition = bone.NowPosition;
            bone.PastAlong = bone.NowAlong;
        }
    }

    /// <summary>Takes the goals of the moment for those of the last substep.</summary>
    internal void Aim()
    {
        for (int i = 0; i < Bones.Length; i++)
        {
            Bones[i].Goal = Bones[i].Shown;
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
                bone.PastPosition -= shift;
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
            bone.PastPosition = (Rotation.Rotate(silent, bone.PastPosition) * grown) - shift;
            bone.PastAlong = Rotation.Rotate(silent, bone.PastAlong);
        }

        Root = root;
    }
}
