using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;

namespace CreatureGen.Sampling.Placement;

/// <summary>The bones of a torso in order from head to tail, with what the attachment rules ask of the whole body. Metres at scale 1.</summary>
internal sealed class SpineMeasure
{
    private readonly SpineBone[] bones;
    private readonly double[] along;

    /// <summary>Takes the bones in order.</summary>
    /// <param name="bones">At least two, head to tail; rings ascend, lengths, widths and thicknesses are positive.</param>
    /// <param name="bodyLength">Length of the body that the legs carry.</param>
    /// <param name="bodyHeight">Height of the body above the ground.</param>
    /// <param name="centreBone">Index of the bone at the body's centre.</param>
    /// <param name="centreOfMass">Centre of mass of the whole body from nose to tail, without limbs.</param>
    /// <exception cref="ArgumentException">A number breaks what is expected of it.</exception>
    public SpineMeasure(IReadOnlyList<SpineBone> bones, double bodyLength, double bodyHeight, int centreBone, SagittalPoint centreOfMass)
    {
        if (bones is null)
        {
            throw new ArgumentNullException(nameof(bones));
        }

        if (bones.Count < 2)
        {
            throw new ArgumentException(FormattableString.Invariant($"the spine has {bones.Count} bones; expected at least 2"), nameof(bones));
        }

        if (!(bodyLength > 0) || double.IsInfinity(bodyLength))
        {
            throw new ArgumentOutOfRangeException(nameof(bodyLength), bodyLength, "the body's length must be a positive number of metres");
        }

        if (!IsFinite(bodyHeight))
        {
            throw new ArgumentOutOfRangeException(nameof(bodyHeight), bodyHeight, "the body's height must be a finite number of metres");
        }

        if (centreBone < 0 || centreBone >= bones.Count)
        {
            throw new ArgumentOutOfRangeException(nameof(centreBone), centreBone, FormattableString.Invariant($"expected the index of one of the {bones.Count} bones"));
        }

        if (!IsFinite(centreOfMass.Y) || !IsFinite(centreOfMass.Z))
        {
            throw new ArgumentException("the centre of mass is not finite", nameof(centreOfMass));
        }

        // Copied first: elements of an interface are handed over one by one.
        this.bones = new SpineBone[bones.Count];
        for (int i = 0; i < this.bones.Length; i++)
        {
            this.bones[i] = bones[i];
        }

        along = new double[this.bones.Length];
        double reached = 0;
        for (int i = 0; i < this.bones.Length; i++)
        {
            ref readonly SpineBone bone = ref this.bones[i];
            Check(bone, i, i == 0 ? -1 : this.bones[i - 1].Ring);
            along[i] = reached + (0.5 * bone.Length);
            reached += bone.Length;
        }

        SpineLength = reached;
        BodyLength = bodyLength;
        BodyHeight = bodyHeight;
        CentreBone = centreBone;
        CentreOfMass = centreOfMass;
    }

    /// <summary>The same bones, which are shared and have been checked, with another centre of mass.</summary>
    private SpineMeasure(SpineMeasure same, SagittalPoint centreOfMass)
    {
        bones = same.bones;
        along = same.along;
        SpineLength = same.SpineLength;
        BodyLength = same.BodyLength;
        BodyHeight = same.BodyHeight;
        CentreBone = same.CentreBone;
        CentreOfMass = centreOfMass;
    }

    /// <summary>The bones, head to tail.</summary>
    public IReadOnlyList<SpineBone> Bones => bones;

    /// <summary>Length of the measured bones together.</summary>
    public double SpineLength { get; }

    /// <summary>Length of the body that the legs carry.</summary>
    public double BodyLength { get; }

    /// <summary>Height of the body above the ground.</summary>
    public double BodyHeight { get; }

    /// <summary>Index of the bone at the body's centre.</summary>
    public int CentreBone { get; }

    /// <summary>Centre of mass of the whole body, without limbs.</summary>
    public SagittalPoint CentreOfMass { get; }

    /// <summary>The body at a ring; linear between the middles of the bones. Beyond the first and the last the spine goes on straight and keeps its thickness.</summary>
    public SpineSection At(double ring)
    {
        int i = 0;
        while (i < bones.Length - 2 && ring >= bones[i + 1].Ring)
        {
            i++;
        }

        SpineBone a = bones[i];
        SpineBone b = bones[i + 1];
        double t = (ring - a.Ring) / (b.Ring - a.Ring);
        double inside = t < 0 ? 0 : t > 1 ? 1 : t;
        double rise = b.Height - a.Height;
        double run = b.Z - a.Z;
        double slope = Math.Sqrt((rise * rise) + (run * run));
        return new SpineSection(
            ring,
            Mix(along[i], along[i + 1], t),
            Mix(a.Z, b.Z, t),
            Mix(a.Height, b.Height, t),
            Mix(a.HipWidth, b.HipWidth, inside),
            Mix(a.Thickness, b.Thickness, inside),
            (along[i + 1] - along[i]) / (b.Ring - a.Ring),
            slope > 0 ? Math.Abs(run) / slope : 1);
    }

    /// <summary>Distance along the spine from its front end to the middle of a bone.</summary>
    public double Along(int bone) => along[bone];

    /// <summary>Index of the bone whose middle is nearest to a ring; of two equally near, the one in front.</summary>
    public int BoneAt(double ring)
    {
        int best = 0;
        for (int i = 1; i < bones.Length; i++)
        {
            if (Math.Abs(bones[i].Ring - ring) < Math.Abs(bones[best].Ring - ring))
            {
                best = i;
            }
        }

        return best;
    }

    /// <summary>The same body with something heavy at another place.</summary>
    /// <param name="z">Where along the ground.</param>
    /// <param name="fraction">Its part of the whole mass, 0..1.</param>
    public SpineMeasure Laden(double z, double fraction) =>
        new(this, new SagittalPoint(CentreOfMass.Y, CentreOfMass.Z + (fraction * (z - CentreOfMass.Z))));

    /// <summary>The same body lifted by <paramref name="metres"/>; negative lowers it.</summary>
    public SpineMeasure Raised(double metres)
    {
        if (metres == 0)
        {
            return this;
        }

        var lifted = new SpineBone[bones.Length];
        for (int i = 0; i < lifted.Length; i++)
        {
            lifted[i] = bones[i] with { Height = bones[i].Height + metres };
        }

        return new SpineMeasure(lifted, BodyLength, BodyHeight + metres, CentreBone, CentreOfMass with { Y = CentreOfMass.Y + metres });
    }

    private static void Check(in SpineBone bone, int index, double previousRing)
    {
        if (bone.Index != index)
        {
            throw new ArgumentException(FormattableString.Invariant($"bone {index}: index is {bone.Index}; expected its place in the list"), "bones");
        }

        if (!(bone.Ring > previousRing) || !(bone.Ring >= 0 && bone.Ring <= BodyGrid.Rings - 1))
        {
            throw new ArgumentException(FormattableString.Invariant($"bone {index}: ring is {bone.Ring}; expected 0..{BodyGrid.Rings - 1}, behind the ring of the bone before it"), "bones");
        }

        if (!(bone.HipWidth > 0 && bone.Length > 0 && bone.Thickness > 0) || !IsFinite(bone.HipWidth + bone.Length + bone.Thickness))
        {
            throw new ArgumentException(FormattableString.Invariant($"bone {index}: width {bone.HipWidth}, length {bone.Length}, thickness {bone.Thickness}; expected positive numbers of metres"), "bones");
        }

        if (!IsFinite(bone.Height) || !IsFinite(bone.Z))
        {
            throw new ArgumentException(FormattableString.Invariant($"bone {index}: height {bone.Height}, z {bone.Z}; expected finite numbers of metres"), "bones");
        }
    }

    private static double Mix(double a, double b, double t) => a + ((b - a) * t);

    private static bool IsFinite(double x) => !double.IsNaN(x) && !double.IsInfinity(x);
}
