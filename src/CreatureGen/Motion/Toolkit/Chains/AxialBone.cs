using System.Numerics;

namespace CreatureGen.Motion.Toolkit.Chains;

/// <summary>A bone of the body's axis in rest pose; points in model space, metres.</summary>
internal readonly struct AxialBone
{
    public AxialBone(JointRotation turn, int parent, Vector3 pivot, Vector3 front, Vector3 rear, double mass)
    {
        Turn = turn;
        Parent = parent;
        Pivot = pivot;
        Front = front;
        Rear = rear;
        Mass = mass;
    }

    /// <summary>Writes its joint. A field: what a property is asked for is done on a copy.</summary>
    public readonly JointRotation Turn;

    /// <summary>The bone that carries it, −1 for the body's root.</summary>
    public int Parent { get; }

    /// <summary>Where its joint is.</summary>
    public Vector3 Pivot { get; }

    /// <summary>Where it meets the bone before it; the nose of the first.</summary>
    public Vector3 Front { get; }

    /// <summary>Where it meets the bone behind it; the tip of the tail of the last.</summary>
    public Vector3 Rear { get; }

    /// <summary>Its share of the mass, 0..1.</summary>
    public double Mass { get; }

    /// <summary>Half way along it.</summary>
    public Vector3 Middle => (Front + Rear) * 0.5f;
}
