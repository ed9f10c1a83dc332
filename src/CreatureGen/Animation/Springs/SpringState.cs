using System.Numerics;
using CreatureGen.Animation.RootMotion;
using CreatureGen.Maths;

namespace CreatureGen.Animation.Springs;

/// <summary>
/// What spring bones remember from frame to frame. Made once per creature and rig; everything is kept relative to the creature's place, so that the world's origin may be anywhere and may be moved.
/// </summary>
public sealed class SpringState
{
    /// <summary>Starts at rest: the first update takes the animated pose as it is.</summary>
    public SpringState(SpringRig rig)
    {
        int count = rig.Joints.Length;
        Rig = rig;
        Offsets = new Vector3[count];
        OffsetsBefore = new Vector3[count];
        Velocities = new Vector3[count];
        Goals = new Vector3[count];
        GoalVelocities = new Vector3[count];
        PastRotations = new Quaternion[count];
        PastPositions = new Vector3[count];
        NowRotations = new Quaternion[count];
        NowPositions = new Vector3[count];
        Animated = new Quaternion[count];
        Rotations = new Quaternion[count];
        Positions = new Vector3[count];
        Steps = new DampedSpring[count];
        Frequencies = new float[count];
        Ratios = new float[count];
        System.Array.Fill(Frequencies, -1f);
        Colliders = System.Array.Empty<SpringCollider>();
    }

    internal SpringRig Rig { get; }

    /// <summary>Whether the fields below mean anything.</summary>
    internal bool Started { get; set; }

    /// <summary>Time not yet simulated, seconds, less than one substep.</summary>
    internal float Debt { get; set; }

    /// <summary>Where the creature was.</summary>
    internal RootPlace Root { get; set; }

    /// <summary>From the goal of each tip to the tip, world axes, world metres.</summary>
    internal Vector3[] Offsets { get; }

    /// <summary>The same one substep earlier.</summary>
    internal Vector3[] OffsetsBefore { get; }

    /// <summary>Velocity of each tip relative to its goal.</summary>
    internal Vector3[] Velocities { get; }

    /// <summary>Goals in the last substep, from the creature's place, world axes.</summary>
    internal Vector3[] Goals { get; }

    /// <summary>Velocities of the goals in the last substep.</summary>
    internal Vector3[] GoalVelocities { get; }

    /// <summary>Animated rotations at the last update, world axes.</summary>
    internal Quaternion[] PastRotations { get; }

    /// <summary>Animated places of the joints at the last update, from the creature's place.</summary>
    internal Vector3[] PastPositions { get; }

    internal Quaternion[] NowRotations { get; }

    internal Vector3[] NowPositions { get; }

    /// <summary>Animated rotations in the substep under way.</summary>
    internal Quaternion[] Animated { get; }

    /// <summary>Simulated rotations in the substep under way.</summary>
    internal Quaternion[] Rotations { get; }

    /// <summary>Simulated places of the joints in the substep under way.</summary>
    internal Vector3[] Positions { get; }

    /// <summary>One substep of each bone's spring.</summary>
    internal DampedSpring[] Steps { get; }

    /// <summary>Hz that <see cref="Steps"/> was worked out for.</summary>
    internal float[] Frequencies { get; }

    /// <summary>Damping ratio that <see cref="Steps"/> was worked out for.</summary>
    internal float[] Ratios { get; }

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

    /// <summary>Goes over to a new place, as if the creature had only moved and turned by a share of the way.</summary>
    internal void Carry(in RootPlace root, float felt)
    {
        Quaternion turn = Rotation.Multiply(root.Rotation, Rotation.Inverse(Root.Rotation));
        Quaternion silent = felt < 1f ? Rotation.Slerp(Quaternion.Identity, turn, 1 - felt) : Quaternion.Identity;
        float grown = root.Scale / Root.Scale;
        Vector3 shift = (root.Position - Root.Position) * felt;
        if (felt >= 1f && grown == 1f)
        {
            for (int i = 0; i < Goals.Length; i++)
            {
                Goals[i] -= shift;
                PastPositions[i] -= shift;
            }

            Root = root;
            return;
        }

        for (int i = 0; i < Offsets.Length; i++)
        {
            Offsets[i] = Rotation.Rotate(silent, Offsets[i]) * grown;
            OffsetsBefore[i] = Rotation.Rotate(silent, OffsetsBefore[i]) * grown;
            Velocities[i] = Rotation.Rotate(silent, Velocities[i]) * grown;
            GoalVelocities[i] = Rotation.Rotate(silent, GoalVelocities[i]) * grown;
            Goals[i] = (Rotation.Rotate(silent, Goals[i]) * grown) - shift;
            PastPositions[i] = (Rotation.Rotate(silent, PastPositions[i]) * grown) - shift;
            PastRotations[i] = Rotation.Multiply(silent, PastRotations[i]);
        }

        Root = root;
    }
}
