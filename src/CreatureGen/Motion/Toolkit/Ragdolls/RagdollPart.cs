using System.Numerics;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Ragdolls;

/// <summary>One rigid part of a ragdoll, with all lengths in model metres and masses as shares of the whole.</summary>
internal readonly struct RagdollPart
{
    public RagdollPart(int joint, int parent, Vector3 centre, float mass, Vector3 inertia, Vector3 pivotInParent, Quaternion restInParent, JointLimit limit)
    {
        Joint = joint;
        Parent = parent;
        Centre = centre;
        InverseMass = 1f / mass;
        InverseInertia = new Vector3(1f / inertia.X, 1f / inertia.Y, 1f / inertia.Z);
        PivotInParent = pivotInParent;
        RestInParent = restInParent;
        Limit = limit;
    }

    /// <summary>The joint that moves it; its axes are the part's.</summary>
    public int Joint { get; }

    /// <summary>Number of the part that it hangs on, −1 for the first.</summary>
    public int Parent { get; }

    /// <summary>Centre of mass from the joint.</summary>
    public Vector3 Centre { get; }

    public float InverseMass { get; }

    /// <summary>About its own axes through the centre of mass; products are left out.</summary>
    public Vector3 InverseInertia { get; }

    /// <summary>The joint, from the parent's centre of mass in the parent's axes.</summary>
    public Vector3 PivotInParent { get; }

    /// <summary>Rest rotation in the parent's axes.</summary>
    public Quaternion RestInParent { get; }

    /// <summary>How far it turns from there.</summary>
    public JointLimit Limit { get; }
}
