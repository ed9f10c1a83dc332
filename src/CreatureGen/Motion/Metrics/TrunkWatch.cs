using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Metrics;

/// <summary>Watches how a trunk goes: how far its middle is from half way between where it was a moment before and where it is a moment after. What goes evenly is there, what falls nearly, and what jumps is not.</summary>
internal sealed class TrunkWatch
{
    /// <summary>Poses from the first of the three moments to the second, and from that to the third.</summary>
    private readonly int moment;
    private readonly int[] joints;
    private readonly Vector3[] places;
    private int recorded;

    /// <summary>Watches a skeleton.</summary>
    /// <param name="skeleton">Its body, pelvis, spine and chest count.</param>
    /// <param name="moment">Poses between two of the moments, above 0.</param>
    public TrunkWatch(Skeleton skeleton, int moment)
    {
        this.moment = moment;
        joints = Array.FindAll(Indices(skeleton.Count), j => skeleton.Joints[j].Role is JointRole.Body or JointRole.Pelvis or JointRole.Spine or JointRole.Chest);
        places = new Vector3[(2 * moment) + 1];
    }

    /// <summary>Farthest from half way, metres.</summary>
    public float Jolt { get; private set; }

    /// <summary>Watches a pose.</summary>
    /// <param name="root">Where the creature is.</param>
    /// <param name="model">Its pose.</param>
    public void Record(in RootPlace root, in Pose model)
    {
        Vector3 sum = Vector3.Zero;
        foreach (int joint in joints)
        {
            sum += model.Positions[joint];
        }

        places[recorded % places.Length] = root.ToWorld(sum / joints.Length);
        recorded++;
        if (recorded >= places.Length)
        {
            Vector3 between = places[(recorded - 1 - moment) % places.Length];
            Vector3 halfWay = (places[recorded % places.Length] + places[(recorded - 1) % places.Length]) * 0.5f;
            Jolt = Math.Max(Jolt, Vec.Distance(between, halfWay));
        }
    }

    private static int[] Indices(int count)
    {
        var indices = new int[count];
        for (int i = 0; i < count; i++)
        {
            indices[i] = i;
        }

        return indices;
    }
}
