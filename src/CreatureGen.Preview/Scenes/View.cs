using System;

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

    private static ArgumentOutOfRangeException Unknown(View view) => new(nameof(view), view, "expected one of the named views");
}
