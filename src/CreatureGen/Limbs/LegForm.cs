using System;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Blueprints;

namespace CreatureGen.Limbs;

/// <summary>
/// The shape of a leg or arm as data: rows of forward, down and outward in units of its length, and fore-aft and lateral radius and offset of the flesh in units of its thickness. Row 0 is the socket.
/// </summary>
internal sealed class LegForm
{
    private static readonly LegForm[] all = Array.ConvertAll(LegKinds.All.ToArray(), kind => new LegForm(kind.Archetype, kind.Outline));
    private static readonly LegForm?[] trailing = Array.ConvertAll(LegKinds.All.ToArray(), kind => kind.Trailing == null ? null : new LegForm(kind.Archetype, kind.Trailing));

    private readonly LegOutline outline;

    private LegForm(LimbArchetype archetype, LegOutline outline)
    {
        this.outline = outline;
        Archetype = archetype;
        ToeLength = (float)outline.ToeLength;
        ToeSplay = (float)outline.ToeSplay;
        ToeRadius = (float)outline.ToeRadius;
        Forward = Column(row => row.Forward);
        Down = Column(row => row.Down);
        Outward = Column(row => row.Outward);
        ForeRadius = Column(row => row.ForeRadius);
        SideRadius = Column(row => row.SideRadius);
        ForeOffset = Column(row => row.ForeOffset);
        SideOffset = Column(row => row.SideOffset);
    }

    public LimbArchetype Archetype { get; }

    public FootEnd End => outline.End;

    public int Rows => outline.Rows.Length;

    public int KneeRow => outline.KneeRow;

    public int AnkleRow => outline.AnkleRow;

    public int BallRow => outline.BallRow;

    /// <summary>Whether it reaches out to the side and turns with its azimuth, instead of standing under the body.</summary>
    public bool Lateral => outline.Lateral;

    /// <summary>Whether it arches out of the body's side on a socket of few cells and ends in a point.</summary>
    public bool Jointed => outline.Jointed;

    /// <summary>Whether it stands on long spread toes under the body.</summary>
    public bool LongToed => outline.LongToed;

    /// <summary>Whether it folds at the side of the body, its foot far out.</summary>
    public bool Crouched => outline.Crouched;

    /// <summary>Whether it ends in a hand.</summary>
    public bool Handed => outline.Handed;

    /// <summary>Whether it is carried close to the body instead of being stood on.</summary>
    public bool Carried => outline.Carried;

    /// <summary>Whether it arches out to the side over a raised knee.</summary>
    public bool Arched => outline.Arched;

    /// <summary>Whether it reaches out to the side on a foot that points ahead.</summary>
    public bool Sprawling => outline.Sprawling;

    /// <summary>Number of last rows whose radii grow with the size of the foot.</summary>
    public int FootRows => outline.FootRows;

    /// <summary>Length of the toes in units of thickness times foot size.</summary>
    public float ToeLength { get; }

    /// <summary>Angle between the outer toes and straight ahead, radians.</summary>
    public float ToeSplay { get; }

    /// <summary>Radius of a toe's tip in units of thickness times foot size.</summary>
    public float ToeRadius { get; }

    public float[] Forward { get; }

    public float[] Down { get; }

    public float[] Outward { get; }

    public float[] ForeRadius { get; }

    public float[] SideRadius { get; }

    public float[] ForeOffset { get; }

    public float[] SideOffset { get; }

    /// <summary>The form of a leg: legs out to the side trail where they do not stand.</summary>
    public static LegForm Of(LegBlueprint leg)
    {
        int kind = (int)LegKinds.Of(leg.Archetype).Archetype;
        return leg.Stance == LegStance.Hanging && trailing[kind] is { } form ? form : all[kind];
    }

    /// <inheritdoc cref="LegOutline.Thickness"/>
    public float Thickness(float wanted, float half, float height) => outline.Thickness(wanted, half, height);

    private float[] Column(Func<LegSection, int> number) => Array.ConvertAll(outline.Rows, row => number(row) / 1000f);
}
