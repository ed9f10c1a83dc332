using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Skinning;

/// <summary>
/// Skin weights by anatomy: every vertex knows where on which part it lies, so its joints follow from its address and not from distances in space.
/// </summary>
/// <remarks>
/// The body's rings go over from bone to bone along the spine (<see cref="SpineSegments"/>), limbs from joint to joint along their path (<see cref="LimbProfile"/>), the skin around a
/// socket follows the limb over three rings (<see cref="SocketSpread"/>), the lower jaw and the bag of the mouth follow the jaw (<see cref="MouthWeights"/>).
/// Only vertices on the left and on the midline are solved; the right ones are their exact mirror images.
/// </remarks>
internal static class AnatomicalWeights
{
    /// <summary>Most that limbs of one side may take of a vertex of the body.</summary>
    private const float MaxPull = 0.65f;

    /// <summary>Most that limbs of both sides may take of a vertex on the midline.</summary>
    private const float MaxMedianPull = 0.4f;

    /// <summary>One set of influences per vertex of the surface.</summary>
    /// <param name="input">The surface and its anatomy, at scale 1.</param>
    /// <param name="rig">The rig built from it.</param>
    public static SkinWeights[] Solve(RigInput input, Rig rig)
    {
        Surface surface = input.Surface;
        var profiles = new LimbProfile?[input.Appendages.Count];
        MidlineFin?[] fins = MidlineFin.Measure(input, rig);
        var spread = SocketSpread.Measure(surface, input.Adjacency, input.Appendages);
        var disc = DiscEdges.In(input, rig.Line);
        float[] jaw = MouthWeights.Solve(surface, input.Adjacency, input.Mouth);
        Span<SpineBlend> rings = stackalloc SpineBlend[BodyGrid.Rings];
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            rings[i] = rig.Spine.At(rig.Line.ArcAt(i));
        }

        var weights = new SkinWeights[surface.Positions.Length];
        var list = new InfluenceList(stackalloc int[InfluenceList.Capacity], stackalloc float[InfluenceList.Capacity]);
        for (int v = 0; v < weights.Length; v++)
        {
            VertexAddress address = surface.Addresses[v];
            if (address.Sign < 0)
            {
                continue;
            }

            list.Clear();
            SpineBlend body = rings[Math.Min(Math.Max((int)(address.Ring + 0.5f), 0), BodyGrid.Rings - 1)];
            if (address.Appendage >= 0)
            {
                Appendage appendage = input.Appendages[address.Appendage];
                LimbProfile profile = profiles[address.Appendage] ??= new LimbProfile(appendage, rig.Appendages[address.Appendage], rig.Skeleton);
                float hold = 1f;
                if (!appendage.Paired)
                {
                    double arc = rig.Line.ArcAt(MidlineFin.RingOf(input.Skin.Shape, surface.Positions[v], address.Ring));
                    body = rig.Spine.At(arc);
                    hold = fins[address.Appendage]!.HoldAt(arc);
                }

                profile.Add(ref list, surface.Positions[v], address, body, hold);
            }
            else
            {
                AddBody(ref list, body);
                if (disc != null)
                {
                    AddDisc(ref list, disc.At(surface.Positions[v], address.Ring, rig.Line.ArcAt(Scalar.Clamp(address.Ring, 0f, BodyGrid.Rings - 1))), rig);
                }

                AddPull(ref list, input, rig, profiles, spread, v);
                if (jaw.Length > 0 && jaw[v] > 0f)
                {
                    list.Scale(1f - jaw[v]);
                    list.Add(rig.Jaw, jaw[v]);
                }
            }

            weights[v] = list.ToWeights();
        }

        SkinMirror.Complete(surface, rig.Skeleton, weights);
        return weights;
    }

    private static void AddBody(ref InfluenceList list, in SpineBlend body)
    {
        list.Add(body.First, 1f - body.SecondWeight);
        list.Add(body.Second, body.SecondWeight);
    }

    /// <summary>Adds what the halves of a disc take of a vertex of the body.</summary>
    private static void AddDisc(ref InfluenceList list, in DiscShare disc, Rig rig)
    {
        if (disc.Share <= 0f)
        {
            return;
        }

        list.Scale(1f - disc.Share);
        for (int row = 0; row < 2; row++)
        {
            int[] joints = rig.Appendages[disc.Front + row].Left;
            float share = disc.Share * (row == 0 ? 1f - disc.Behind : disc.Behind);
            list.Add(joints[0], share * (1f - disc.Outer));
            list.Add(joints[1], share * disc.Outer);
        }
    }

    /// <summary>Adds what limbs near a vertex of the body pull along. A vertex on the midline is pulled equally by both sides, by one pair at most, so that its four influences stay symmetric.</summary>
    private static void AddPull(ref InfluenceList list, RigInput input, Rig rig, LimbProfile?[] profiles, SocketSpread spread, int vertex)
    {
        int mirror = input.Surface.Mirror[vertex];
        if (spread.First(vertex) < 0 && spread.First(mirror) < 0)
        {
            return;
        }

        if (mirror == vertex)
        {
            AddMedianPull(ref list, input, rig, profiles, spread, vertex);
            return;
        }

        float total = Total(input, rig, profiles, spread, vertex) + Total(input, rig, profiles, spread, mirror);
        float factor = total > MaxPull ? MaxPull / total : 1f;
        list.Scale(1f - (total * factor));
        for (int e = spread.First(vertex); e >= 0; e = spread.Next(e))
        {
            int a = spread.Appendage(e);
            profiles[a]!.AddPull(ref list, spread.Distance(e), rig.Appendages[a].Left, factor);
        }

        for (int e = spread.First(mirror); e >= 0; e = spread.Next(e))
        {
            int a = spread.Appendage(e);
            profiles[a]!.AddPull(ref list, spread.Distance(e), rig.Appendages[a].Right, factor);
        }
    }

    private static void AddMedianPull(ref InfluenceList list, RigInput input, Rig rig, LimbProfile?[] profiles, SocketSpread spread, int vertex)
    {
        int best = -1;
        float pull = 0f;
        for (int e = spread.First(vertex); e >= 0; e = spread.Next(e))
        {
            int a = spread.Appendage(e);
            LimbProfile profile = profiles[a] ??= new LimbProfile(input.Appendages[a], rig.Appendages[a], rig.Skeleton);
            float fraction = profile.Border[spread.Distance(e)];
            if (fraction > pull)
            {
                pull = fraction;
                best = a;
            }
        }

        if (best < 0)
        {
            return;
        }

        pull = Math.Min(pull, MaxMedianPull / 2f);
        int root = input.Appendages[best].Kind is LimbKind.Leg or LimbKind.Arm ? 1 : 0;
        list.Scale(1f - (2f * pull));
        list.Add(rig.Appendages[best].Left[root], pull);
        list.Add(rig.Appendages[best].Right[root], pull);
    }

    private static float Total(RigInput input, Rig rig, LimbProfile?[] profiles, SocketSpread spread, int vertex)
    {
        float total = 0f;
        for (int e = spread.First(vertex); e >= 0; e = spread.Next(e))
        {
            int a = spread.Appendage(e);
            LimbProfile profile = profiles[a] ??= new LimbProfile(input.Appendages[a], rig.Appendages[a], rig.Skeleton);
            total += profile.PullAt(spread.Distance(e));
        }

        return total;
    }
}
