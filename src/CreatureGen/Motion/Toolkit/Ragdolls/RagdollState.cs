using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ragdolls;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Where the parts of a ragdoll are and how they move. Made once per creature; everything is kept relative to where it started, so that the world's origin may be anywhere and may be moved.</summary>
public sealed class RagdollState
{
    /// <summary>Makes room for a rig; nothing moves before <see cref="Ragdoll.Start"/>.</summary>
    public RagdollState(RagdollRig rig)
    {
        Rig = rig;
        int count = rig.Count;
        Positions = new Vector3[count];
        Rotations = new Quaternion[count];
        Velocities = new Vector3[count];
        Spins = new Vector3[count];
        PastPositions = new Vector3[count];
        PastRotations = new Quaternion[count];
        Targets = new Quaternion[count];
        Tones = new float[count];
        Excesses = new float[count];
        Slides = new Vector3[count];
        Allowances = new float[rig.Contacts.Length];
        Aparts = new float[rig.Pairs.Length];
    }

    /// <summary>Whether a ragdoll is under way.</summary>
    public bool IsActive { get; internal set; }

    /// <summary>Whether everything has come to rest; a push wakes it.</summary>
    public bool IsAsleep { get; internal set; }

    /// <summary>Root mean square of the speed over the mass, world m/s, turning counted at a tenth of the creature's size.</summary>
    public float Speed { get; internal set; }

    internal RagdollRig Rig { get; }

    /// <summary>World position that all others are relative to.</summary>
    internal Vector3 Anchor { get; set; }

    /// <summary>World metres per model metre.</summary>
    internal float Scale { get; set; }

    /// <summary>Time not yet simulated, seconds.</summary>
    internal float Debt { get; set; }

    /// <summary>Seconds for which it has hardly moved.</summary>
    internal float Calm { get; set; }

    /// <summary>Seconds since it last moved as fast as in a fall, or was pushed.</summary>
    internal float Restless { get; set; }

    /// <summary>Centres of mass, from the anchor, world axes.</summary>
    internal Vector3[] Positions { get; }

    internal Quaternion[] Rotations { get; }

    internal Vector3[] Velocities { get; }

    /// <summary>Angular velocities, world axes, rad/s.</summary>
    internal Vector3[] Spins { get; }

    internal Vector3[] PastPositions { get; }

    internal Quaternion[] PastRotations { get; }

    /// <summary>Rotations that muscles pull to, in the parents' axes.</summary>
    internal Quaternion[] Targets { get; }

    /// <summary>Tone of the muscles that hold each part on its parent, beside that of the material; s⁻¹.</summary>
    internal float[] Tones { get; }

    /// <summary>How far each part may still be beyond its limit, since the motion had it there; radians.</summary>
    internal float[] Excesses { get; }

    /// <summary>How far each part's joint may still be from its place on the parent, since the motion had it there, as folded wings do; parent's axes, model metres.</summary>
    internal Vector3[] Slides { get; }

    /// <summary>How deep each ball may still be in the ground, since it started there; model metres.</summary>
    internal float[] Allowances { get; }

    /// <summary>How far apart the bones of each pair stay: no farther than they started; model metres.</summary>
    internal float[] Aparts { get; }

    /// <summary>World position of the centre of mass of the part that a joint belongs to, metres.</summary>
    /// <param name="joint">Skeleton index.</param>
    internal Vector3 CentreOf(int joint) => Anchor + Positions[Rig.PartOfJoint[joint]];

    /// <summary>World position of the first part's joint, metres.</summary>
    internal Vector3 FirstPlace => Anchor + Positions[0] - (Rotation.Rotate(Rotations[0], Rig.Parts[0].Centre) * Scale);

    /// <summary>Turn of the first part from rest, world axes.</summary>
    internal Quaternion FirstTurn => Rotation.Multiply(Rotations[0], Rotation.Inverse(Rig.Skeleton.ModelRotations[Rig.FirstJoint]));

    /// <summary>Angular velocity of the first part, world axes, rad/s.</summary>
    internal Vector3 FirstSpin => Spins[0];

    /// <summary>Sets the whole turning about its centre of mass, as if it were rigid.</summary>
    /// <param name="change">Of its angular velocity, world axes, rad/s.</param>
    internal void Turn(Vector3 change)
    {
        ReadOnlySpan<RagdollPart> parts = Rig.Parts;
        Vector3 centre = Vector3.Zero;
        float mass = 0f;
        for (int i = 0; i < parts.Length; i++)
        {
            centre += Positions[i] / parts[i].InverseMass;
            mass += 1f / parts[i].InverseMass;
        }

        centre /= mass;
        for (int i = 0; i < parts.Length; i++)
        {
            Velocities[i] += Vec.Cross(change, Positions[i] - centre);
            Spins[i] += change;
        }
    }

    /// <summary>Goes on from where another of the same rig is.</summary>
    internal void CopyFrom(RagdollState other)
    {
        (IsActive, IsAsleep, Speed, Anchor, Scale, Debt, Calm, Restless) = (other.IsActive, other.IsAsleep, other.Speed, other.Anchor, other.Scale, other.Debt, other.Calm, other.Restless);
        other.Positions.CopyTo(Positions, 0);
        other.Rotations.CopyTo(Rotations, 0);
        other.Velocities.CopyTo(Velocities, 0);
        other.Spins.CopyTo(Spins, 0);
        other.PastPositions.CopyTo(PastPositions, 0);
        other.PastRotations.CopyTo(PastRotations, 0);
        other.Targets.CopyTo(Targets, 0);
        other.Tones.CopyTo(Tones, 0);
        other.Excesses.CopyTo(Excesses, 0);
        other.Slides.CopyTo(Slides, 0);
        other.Allowances.CopyTo(Allowances, 0);
        other.Aparts.CopyTo(Aparts, 0);
    }

    /// <summary>Ends the ragdoll.</summary>
    public void Stop() => IsActive = false;

    /// <summary>Tells that the world's origin was moved, so that all positions changed by an offset and nothing else did.</summary>
    /// <param name="offset">Added to every position of the world, metres.</param>
    /// <exception cref="ArgumentException">The offset is not finite.</exception>
    public void Rebase(Vector3 offset)
    {
        Finite.Require(offset, nameof(offset));
        Anchor += offset;
    }

    /// <summary>Hits one part.</summary>
    /// <param name="joint">A joint of it.</param>
    /// <param name="velocity">Change of its velocity at the point, world m/s, as if it were free.</param>
    /// <param name="point">Where, world space, metres.</param>
    /// <exception cref="ArgumentException">A number is not finite, or there is no such joint.</exception>
    public void Push(int joint, Vector3 velocity, Vector3 point)
    {
        Finite.Require(velocity, nameof(velocity));
        Finite.Require(point, nameof(point));
        if ((uint)joint >= (uint)Rig.PartOfJoint.Length)
        {
            throw new ArgumentOutOfRangeException(nameof(joint), FormattableString.Invariant($"joint {joint}; expected 0 to {Rig.PartOfJoint.Length - 1}"));
        }

        int part = Rig.PartOfJoint[joint];
        RagdollSolver.Push(this, part, velocity, point - Anchor);
        IsAsleep = false;
        Calm = 0f;
        Restless = 0f;
    }
}
