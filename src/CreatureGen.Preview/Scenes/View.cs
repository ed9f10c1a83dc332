using System;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;

namespace CreatureGen.Preview.Scenes;

/// <summary>A named side from which a creature is looked at. The creature faces +Z and +X is its left.</summary>
public enum View
{
    /// <summary>From its front left and a little above.</summary>
    ThreeQuarter,

    /// <summary>From its left; it faces the left edge of the picture.</summary>
    Side,

    /// <summary>Into its face.</summary>
    Front,

    /// <summary>From behind.</summary>
    Back,

    /// <summary>Straight down on its back; it faces the top edge of the picture.</summary>
    Top,
}

/// <summary>The words for views, and their angles.</summary>
public static class Views
{
    /// <summary>The three-quarter view of what flies: raised wings have the inner part of their blades in the line of sight of who looks from farther ahead or from above, and would be pipes there.</summary>
    private static readonly CameraAngle besideWings = new(46, 1);

    /// <summary>The view of a whole creature from behind: beside it and above, as who photographs animals that walk away stands. From straight behind and no higher than the rump, that, a tail or a fluke is all that is seen.</summary>
    private static readonly CameraAngle pastTheRump = new(157, 14);

    /// <summary>Angle of view along a body, degrees, that of a telephoto lens: from close by, what is at the near end of a long body is several times as large as what is at the far one.</summary>
    private const double AlongTheBody = 12;

    private static readonly string[] Words = ["three-quarter", "side", "front", "back", "top"];

    /// <summary>The word for a view: <c>three-quarter</c>, <c>side</c>, <c>front</c>, <c>back</c> or <c>top</c>.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It is none of the named views.</exception>
    public static string Word(View view) => (uint)view < (uint)Words.Length ? Words[(int)view] : throw Unknown(view);

    /// <summary>Finds the view with the given word, exactly as <see cref="Word"/> gives it.</summary>
    /// <returns>Whether there is one.</returns>
    public static bool TryParse(string word, out View view)
    {
        int index = Array.IndexOf(Words, word);
        view = (View)Math.Max(0, index);
        return index >= 0;
    }

    /// <summary>From where a view looks.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It is none of the named views.</exception>
    public static CameraAngle Angle(View view) => view switch
    {
        View.ThreeQuarter => new CameraAngle(38, 14),
        View.Side => new CameraAngle(90, 6),
        View.Front => new CameraAngle(0, 6),
        View.Back => new CameraAngle(180, 6),
        View.Top => new CameraAngle(0, 90),
        _ => throw Unknown(view),
    };

    /// <summary>From where a view looks at a whole creature: in three-quarter view at what flies from farther to the side and from lower down than at others, so that the blades of both wings are seen; from behind past the rump, so that flank, back and head are.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It is none of the named views.</exception>
    public static CameraAngle Angle(View view, Creature creature)
    {
        ArgumentNullException.ThrowIfNull(creature);
        return view switch
        {
            View.ThreeQuarter when creature.Blueprint.Kind == LocomotionKind.Flying => besideWings,
            View.Back => pastTheRump,
            _ => Angle(view),
        };
    }

    /// <summary>Vertical angle of view of the lens for whole creatures, degrees: that of a portrait lens, and of a longer one where a view looks along the body.</summary>
    public static double FieldOfView(View view) => view is View.Front or View.Back ? AlongTheBody : Camera.PortraitFieldOfView;

    private static ArgumentOutOfRangeException Unknown(View view) => new(nameof(view), view, "expected one of the named views");
}
