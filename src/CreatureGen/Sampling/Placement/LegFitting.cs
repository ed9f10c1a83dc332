using System;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Sampling.Placement;

/// <summary>Which thickness a leg is given.</summary>
internal enum LegGirth
{
    /// <summary>What the body's thickness asks for.</summary>
    Nominal,

    /// <summary>The least that its built form allows, to make room.</summary>
    Min,
}

/// <summary>The size that a leg takes at a place of the body.</summary>
internal static class LegFitting
{
    /// <summary>Gap between a foot and the body's plane, metres: left and right feet do not touch.</summary>
    public const double MidlineGap = 0.012;

    /// <summary>A patch of cells lets the root of a limb swell beyond its border by this factor.</summary>
    private const double PatchSwell = 1.12;

    /// <summary>Legs shorter than this are measured as if they were this long, metres, so that a body on the ground still gives finite answers.</summary>
    private const double ShortestMeasured = 0.01;

    /// <summary>Proves that sizes are finite and positive.</summary>
    /// <exception cref="ArgumentOutOfRangeException">One is not.</exception>
    public static void Check(LegSize size)
    {
        double sum = size.Girth + size.Reach + size.Foot;
        if (!(size.Girth > 0 && size.Reach > 0 && size.Foot > 0 && size.Toes >= 0) || double.IsInfinity(sum))
        {
            throw new ArgumentOutOfRangeException(nameof(size), size, "expected finite, positive factors and no negative number of toes");
        }
    }

    /// <summary>Height above the ground of the attachment point on the flank: the spine's height, less what the segment lies below the side of the body.</summary>
    public static double AttachmentHeight(in SpineSection section, double segment) =>
        section.Height + (0.5 * section.Thickness * section.Level * PortableMath.Cos(Angle(segment)));

    /// <summary>A standing pair: its length is the distance from the attachment point to the ground.</summary>
    public static LegPlacement Stand(SpineMeasure measure, LimbSocket site, LegSize size, LegGirth girth)
    {
        SpineSection section = measure.At(site.Ring);
        double height = Math.Max(ShortestMeasured, AttachmentHeight(section, site.Segment));
        LegBuild build = LegKinds.Of(site.Archetype).Build;
        double reach = site.Reach * measure.BodyLength * size.Reach;
        return Place(measure, section, site, size, girth, height, 0, reach, build.SwingSine());
    }

    /// <summary>A hanging pair of the given length, metres.</summary>
    /// <param name="measure">The body.</param>
    /// <param name="site">Where it grows.</param>
    /// <param name="size">Size of legs.</param>
    /// <param name="length">Length, positive.</param>
    /// <param name="factor">Factor on its girth and reach.</param>
    public static LegPlacement Hang(SpineMeasure measure, LimbSocket site, LegSize size, double length, double factor)
    {
        SpineSection section = measure.At(site.Ring);
        double height = AttachmentHeight(section, site.Segment);
        double reach = site.Reach * measure.BodyLength * size.Reach * factor;
        LimbSocket scaled = site with { Girth = site.Girth * factor };
        LegPlacement leg = Place(measure, section, scaled, size, LegGirth.Nominal, height, height - length, reach, LegBuild.HangingSwingSine());
        return leg with { Site = site };
    }

    private static LegPlacement Place(
        SpineMeasure measure,
        in SpineSection section,
        LimbSocket site,
        LegSize size,
        LegGirth girth,
        double height,
        double tip,
        double reach,
        double swingSine)
    {
        LegBuild build = LegKinds.Of(site.Archetype).Build;
        bool splayed = build.Posture == LimbPosture.Splayed;
        double unit = splayed ? reach : height - tip;
        double min = build.MinGirth * unit;

        // The socket follows the body, the root's radius also the leg: a thin body's long leg swells over a small socket.
        double wanted = girth == LegGirth.Min ? min : 0.5 * section.Thickness * site.Girth * size.Girth;
        SocketBlueprint socket = SocketSizing.Size(
            site.Ring,
            site.Segment,
            wanted,
            wanted * build.SideGirth,
            section.RingSpacing,
            SocketSizing.SegmentSpacing(section.HipWidth, section.Thickness),
            size.Toes,
            site.Bounds);
        double radius = Scalar.Clamp(Math.Min(wanted, PatchSwell * 0.5 * socket.Rows * section.RingSpacing), min, build.GreatestGirth * unit);

        double sole = radius * size.Foot;
        double halfWidth = build.HalfWidth * sole;
        double outward = build.FootOutward * unit * (splayed ? PortableMath.Cos(site.Azimuth) : 1);
        double forward = (build.FootForward * unit) + (splayed ? build.FootOutward * unit * PortableMath.Sin(site.Azimuth) : 0);
        double side = 0.5 * section.HipWidth * PortableMath.Sin(Angle(site.Segment));
        var foot = new FootContact(
            Math.Max(side + outward, halfWidth + MidlineGap),
            section.Z + forward,
            halfWidth,
            build.Heel * sole,
            build.Toe * sole);
        double swing = swingSine * (splayed ? build.FootOutward * reach : height - tip);
        return new LegPlacement(measure.BoneAt(site.Ring), site, socket, section.Along, section.Z, height, tip, radius, reach, swing, foot, 0);
    }

    private static double Angle(double segment) => PortableMath.Tau * segment / Anatomy.BodyGrid.Segments;
}
