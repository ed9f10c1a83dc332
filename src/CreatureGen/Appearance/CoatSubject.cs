using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Beaks;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;

namespace CreatureGen.Appearance;

/// <summary>What a coat has to know of the body that wears it.</summary>
internal sealed class CoatSubject
{
    public CoatSubject(BodyShape body) => Body = body;

    /// <summary>Sections of the body in rest pose, metres at scale 1.</summary>
    public BodyShape Body { get; }

    public SnoutKind Snout { get; set; }

    /// <summary>The form of its beak; null for none, and for one that is nothing but painted.</summary>
    public BeakForm? Beak { get; set; }

    /// <summary>The edges of its lips; null for a head without a mouth slit, and below a beak.</summary>
    public MouthLine? Lips { get; set; }

    /// <summary>Marking of the head; <see cref="HeadMarks.FromSeed"/> chooses one.</summary>
    public HeadMark Mark { get; set; }

    /// <summary>What is seen of its gills.</summary>
    public GillMark Gills { get; set; }

    /// <summary>Hard cover over the back.</summary>
    public ShellBlueprint Shell { get; set; } = new(ShellStyle.None, 24, 20, 6, 0);

    /// <summary>Fields of hair.</summary>
    public IReadOnlyList<ManeBlueprint> Manes { get; set; } = System.Array.Empty<ManeBlueprint>();

    /// <summary>End of the tail.</summary>
    public TailStyle Tail { get; set; }

    /// <summary>Style of the wing with the appendage number of the index; entries of other appendages are not looked at.</summary>
    public IReadOnlyList<WingStyle> WingStyles { get; set; } = System.Array.Empty<WingStyle>();

    /// <summary>Centre of the left eye, metres at scale 1.</summary>
    public Vector3 EyeCentre { get; set; }

    /// <summary>Radius of the eye, metres at scale 1; 0 for a head without eyes.</summary>
    public float EyeRadius { get; set; }

    /// <summary>Ring of the body at the eye.</summary>
    public float EyeRing { get; set; }

    /// <summary>Radians around the body at the eye, 0 on the midline of its top.</summary>
    public float EyeAround { get; set; }
}
