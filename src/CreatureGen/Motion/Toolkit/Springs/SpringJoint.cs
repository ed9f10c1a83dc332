using System.Numerics;
using CreatureGen.Motion.Toolkit.Ik;

namespace CreatureGen.Motion.Toolkit.Springs;

/// <summary>What a rig knows of one joint that swings, side by side in memory: in a crowd a list for each of these numbers would be fetched anew for each creature. Fields, so that what is asked of one is not asked of a copy.</summary>
internal struct SpringJoint
{
    /// <summary>Its place in the skeleton.</summary>
    public int Joint;

    /// <summary>The joint that it hangs on, by its place in the skeleton; −1 for none.</summary>
    public int Carrier;

    /// <summary>Number of that among the joints that swing, −1 for a root.</summary>
    public int Parent;

    /// <summary>From the joint to its tip, along its bone, model metres.</summary>
    public float Length;

    /// <summary>Unit direction of the bone in the joint's own space.</summary>
    public Vector3 Direction;

    /// <summary>How far it turns.</summary>
    public LocalLimit Limit;
}
