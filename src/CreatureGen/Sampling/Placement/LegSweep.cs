using System;

namespace CreatureGen.Sampling.Placement;

/// <summary>Whether two pairs of legs get in each other's way, with the room that they take at rest and in motion.</summary>
/// <remarks>
/// Seen from the side a leg is a cone from its root to its sole, widened by its swing, which grows from nothing at the root to ±(length × sine of the hip's swing) at the foot.
/// Two cones have straight sides, so they cross exactly if they cross at the top or at the bottom of the heights that both legs fill. The roots are compared along the spine,
/// everything below along the ground.
/// </remarks>
internal static class LegSweep
{
    /// <summary>
    /// The part of both swings that two neighbouring pairs may share, because they use it at different times: a hind foot may come down where the fore foot has just left.
    /// Stance takes about ±22° of the hip in a walk and ±27° in a trot, so legs that keep half of ±35° clear of each other never meet at a walk and only graze at a trot.
    /// </summary>
    public const double SharedSwing = 0.5;

    /// <summary>Whether two pairs may not be attached together: their sockets need the same cells, or their sweeps overlap.</summary>
    public static bool Crosses(LegPlacement a, LegPlacement b) => SocketsTouch(a, b) || Overlap(a, b) > 0;

    /// <summary>Whether the rows of two sockets, with the room around them, overlap along the body.</summary>
    public static bool SocketsTouch(LegPlacement a, LegPlacement b)
    {
        int pad = Math.Max(a.Site.Bounds.Pad, b.Site.Bounds.Pad);
        return a.Socket.Ring < b.Socket.Ring + b.Socket.Rows + pad && b.Socket.Ring < a.Socket.Ring + a.Socket.Rows + pad;
    }

    /// <summary>How far the sweeps of two pairs overlap at worst, beyond the shared part of the swings, metres; zero or negative when they are clear.</summary>
    public static double Overlap(LegPlacement a, LegPlacement b)
    {
        LegPlacement front = a.Along <= b.Along ? a : b;
        LegPlacement rear = ReferenceEquals(front, a) ? b : a;
        double worst = front.RootRadius + rear.RootRadius - (rear.Along - front.Along);
        double top = Math.Min(front.RootHeight, rear.RootHeight);
        double bottom = Math.Max(front.TipHeight, rear.TipHeight);
        if (top > bottom)
        {
            worst = Math.Max(worst, OverlapAt(front, rear, bottom));
            if (front.RootHeight != rear.RootHeight)
            {
                worst = Math.Max(worst, OverlapAt(front, rear, top));
            }
        }

        return worst;
    }

    /// <summary>The interval along the ground, z from rear to front, that a leg sweeps at a height, its swing counted in full.</summary>
    public static (double Rear, double Front) Interval(LegPlacement leg, double height)
    {
        (double centre, double rear, double front) = Extent(leg, height, 1);
        return (centre - rear, centre + front);
    }

    private static double OverlapAt(LegPlacement front, LegPlacement rear, double height)
    {
        (double frontCentre, double back, double _) = Extent(front, height, 1 - SharedSwing);
        (double rearCentre, double _, double ahead) = Extent(rear, height, 1 - SharedSwing);
        return back + ahead - (frontCentre - rearCentre);
    }

    private static (double Centre, double Rear, double Front) Extent(LegPlacement leg, double height, double swingPart)
    {
        double down = Math.Min(1, Math.Max(0, (leg.RootHeight - height) / leg.Length));
        double root = leg.RootRadius * (1 - down);
        double swing = leg.Swing * swingPart * down;
        return (leg.RootZ + ((leg.Foot.Z - leg.RootZ) * down), root + (leg.Foot.Heel * down) + swing, root + (leg.Foot.Toe * down) + swing);
    }
}
