using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Rigging;

/// <summary>What the joints of a skeleton from elsewhere are: told by their names, and where those are silent by how joints hang on one another and where they are. What is known already stays.</summary>
/// <remarks>
/// <para>Limbs whose names say no more than leg or arm, or do not begin with a hip, are numbered from the trunk outwards. What both legs hang on is the pelvis, whatever it is called. Of skeletons whose names tell of no limb,
/// chains of joints that leave the midline in mirrored pairs are limbs, if one pair reaches down. Where nothing is called the head, it is the last joint of the neck.</para>
/// </remarks>
internal sealed class JointRoles
{
    /// <summary>Part of the skeleton's size within which joints are on the midline, or in each other's mirror image.</summary>
    private const float Near = 0.02f;

    /// <summary>Part of the skeleton's height below which a leg ends.</summary>
    private const float Low = 0.3f;

    /// <summary>Most joints of a skeleton that is searched for limbs without names.</summary>
    private const int MaxUnnamed = 1024;

    private readonly IReadOnlyList<string> names;
    private readonly int[] parents;
    private readonly Vector3[] places;
    private readonly JointRole[] roles;
    private readonly Side[] sides;
    private readonly bool[] open;
    private readonly bool[] limbs;
    private readonly int[] main;
    private readonly int[] ends;
    private readonly float lowest;
    private readonly float height;
    private readonly float near;

    private JointRoles(IReadOnlyList<string> names, int[] parents, Vector3[] places, JointRole[] roles, Side[] sides)
    {
        this.names = names;
        this.parents = parents;
        this.places = places;
        this.roles = roles;
        this.sides = sides;
        open = Array.ConvertAll(roles, role => role == JointRole.Other);
        limbs = new bool[parents.Length];
        main = MainChildren.Find(parents, places);
        ends = new int[parents.Length];
        (Vector3 low, Vector3 high) = (places[0], places[0]);
        for (int i = parents.Length - 1; i >= 0; i--)
        {
            ends[i] = main[i] >= 0 ? ends[main[i]] : i;
            low = Vec.Min(low, places[i]);
            high = Vec.Max(high, places[i]);
        }

        lowest = low.Y;
        height = high.Y - low.Y;
        near = Near * Math.Max(height, Math.Max(high.X - low.X, high.Z - low.Z));
    }

    /// <summary>Fills in roles and sides.</summary>
    /// <param name="names">Of the joints.</param>
    /// <param name="parents">Of each, −1 for the first; parents before children.</param>
    /// <param name="places">In model space at rest, +Y up, +X left.</param>
    /// <param name="roles">Those that are <see cref="JointRole.Other"/> are told.</param>
    /// <param name="sides">Of joints whose roles are told; those that are <see cref="Side.Median"/> are told.</param>
    public static void Tell(IReadOnlyList<string> names, int[] parents, Vector3[] places, JointRole[] roles, Side[] sides)
    {
        if (Array.IndexOf(roles, JointRole.Other) >= 0)
        {
            new JointRoles(names, parents, places, roles, sides).Tell();
        }
    }

    private void Tell()
    {
        ReadNames();
        if (Array.IndexOf(limbs, true) < 0 && roles.Length <= MaxUnnamed)
        {
            FindMirroredLimbs();
        }

        TellPelvisOfHips();
        NumberLimbs();
        TellMissingPelvis();
        TellMissingHead();
    }

    private void ReadNames()
    {
        for (int i = 0; i < roles.Length; i++)
        {
            roles[i] = open[i] ? JointNames.RoleOf(names[i]) : roles[i];
            sides[i] = open[i] && sides[i] == Side.Median ? JointNames.SideOf(names[i]) : sides[i];
            limbs[i] = roles[i] is JointRole.Hip or JointRole.Knee or JointRole.Ankle or JointRole.Ball || (roles[i] == JointRole.Other && JointNames.SaysLimb(names[i]));
        }
    }

    /// <summary>Chains that leave the midline where another leaves it on the other side.</summary>
    private void FindMirroredLimbs()
    {
        var starts = new List<int>();
        bool stands = false;
        for (int i = 1; i < roles.Length; i++)
        {
            if (LeavesMidline(i) && HasMirror(i))
            {
                starts.Add(i);
                stands |= places[ends[i]].Y <= lowest + (Low * height);
            }
        }

        foreach (int start in starts)
        {
            for (int i = start; stands && i >= 0; i = main[i])
            {
                limbs[i] = open[i];
            }
        }
    }

    private bool LeavesMidline(int joint) => open[joint] && main[joint] >= 0 && Math.Abs(places[joint].X) > near && Math.Abs(places[parents[joint]].X) <= near;

    private bool HasMirror(int joint)
    {
        var mirrored = new Vector3(-places[joint].X, places[joint].Y, places[joint].Z);
        for (int i = 1; i < roles.Length; i++)
        {
            if (parents[i] == parents[joint] && main[i] >= 0 && Vec.Distance(places[i], mirrored) <= near)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>A hip on the midline that legs of both sides hang on is the pelvis.</summary>
    private void TellPelvisOfHips()
    {
        bool[] left = new bool[roles.Length];
        bool[] right = new bool[roles.Length];
        for (int i = roles.Length - 1; i > 0; i--)
        {
            if (limbs[i] && open[i] && sides[i] == Side.Median && left[i] && right[i])
            {
                (roles[i], limbs[i]) = (roles[i] == JointRole.Hip ? JointRole.Pelvis : roles[i], false);
            }

            Side side = limbs[i] ? SideOf(i) : Side.Median;
            left[parents[i]] |= left[i] || side == Side.Left;
            right[parents[i]] |= right[i] || side == Side.Right;
        }
    }

    /// <summary>Names the joints of limbs: those that names tell, the others by their order.</summary>
    private void NumberLimbs()
    {
        // The joint of the limb that each hangs on, whatever lies between, whether one of the limb hangs on it, and whether names tell where the limb begins.
        int[] above = new int[roles.Length];
        bool[] goesOn = new bool[roles.Length];
        bool[] begins = new bool[roles.Length];
        for (int i = 0; i < roles.Length; i++)
        {
            int parent = parents[i];
            above[i] = parent < 0 ? -1 : limbs[parent] ? parent : above[parent];
            if (limbs[i] && above[i] >= 0)
            {
                goesOn[above[i]] = true;
            }
        }

        for (int i = 0; i < roles.Length; i++)
        {
            if (!limbs[i])
            {
                continue;
            }

            int before = above[i];
            begins[i] = before < 0 ? roles[i] == JointRole.Hip : begins[before];
            if (open[i])
            {
                sides[i] = before >= 0 && sides[i] == Side.Median ? sides[before] : SideOf(i);
                if (before >= 0)
                {
                    roles[i] = Onward(roles[before], roles[i], begins[i]);
                }
                else if (goesOn[i] && !begins[i])
                {
                    BeginLimb(i);
                }
            }
        }
    }

    /// <summary>A limb that names do not begin begins with its first joint, or with the shoulder that an elbow hangs on.</summary>
    private void BeginLimb(int first)
    {
        int parent = parents[first];
        bool shoulder = parent >= 0 && open[parent] && roles[parent] == JointRole.Girdle && roles[first] == JointRole.Knee;
        roles[shoulder ? parent : first] = JointRole.Hip;
    }

    private static JointRole Onward(JointRole before, JointRole told, bool begins)
    {
        bool fits = told != JointRole.Other && (begins || told > before);
        return fits ? told : before is JointRole.Hip or JointRole.Knee or JointRole.Ankle ? before + 1 : JointRole.Other;
    }

    /// <summary>Where nothing is the pelvis or the body, it is what all limbs hang on.</summary>
    private void TellMissingPelvis()
    {
        if (Array.IndexOf(roles, JointRole.Pelvis) >= 0 || Array.IndexOf(roles, JointRole.Body) >= 0)
        {
            return;
        }

        int common = -1;
        for (int i = 1; i < roles.Length; i++)
        {
            if (roles[i] == JointRole.Hip)
            {
                common = common < 0 ? parents[i] : CommonOf(common, parents[i]);
            }
        }

        if (common >= 0 && open[common])
        {
            roles[common] = JointRole.Pelvis;
        }
    }

    /// <summary>Where nothing is the head, it is the last joint of a neck of two or more.</summary>
    private void TellMissingHead()
    {
        int last = Array.LastIndexOf(roles, JointRole.Neck);
        if (last > 0 && open[last] && roles[parents[last]] == JointRole.Neck && Array.IndexOf(roles, JointRole.Head) < 0)
        {
            roles[last] = JointRole.Head;
        }
    }

    /// <summary>The side that a joint's name tells, or else the place of the end of what hangs on it.</summary>
    private Side SideOf(int joint)
    {
        float x = places[ends[joint]].X;
        return sides[joint] != Side.Median ? sides[joint] : x > near ? Side.Left : x < -near ? Side.Right : Side.Median;
    }

    private int CommonOf(int a, int b)
    {
        while (a != b)
        {
            (a, b) = a > b ? (parents[a], b) : (a, parents[b]);
        }

        return a;
    }
}
