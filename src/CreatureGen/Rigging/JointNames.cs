using System;
using CreatureGen.Anatomy;

namespace CreatureGen.Rigging;

/// <summary>What joints are, told from their names: those of grown creatures, and the usual ones of other programs (Mixamo, Biped, Rigify, VRM). What names leave open, <see cref="Skeleton.Build"/> tells from how joints hang on one another.</summary>
public static class JointNames
{
    // In the order in which they are asked; more special words first. Names are compared in lower case without digits and marks.
    private static readonly (string Word, JointRole Role)[] words =
    {
        ("end", JointRole.End), ("nub", JointRole.End),
        ("twist", JointRole.Other), ("finger", JointRole.Other), ("thumb", JointRole.Other), ("handindex", JointRole.Other), ("handmiddle", JointRole.Other), ("handring", JointRole.Other), ("handpinky", JointRole.Other),
        ("antenna", JointRole.Antenna), ("insectwing", JointRole.Wing), ("wing", JointRole.Wing),
        ("lid", JointRole.Lid), ("eye", JointRole.Eye), ("leftear", JointRole.Ear), ("rightear", JointRole.Ear), ("ear", JointRole.Ear), ("jaw", JointRole.Jaw),
        ("tail", JointRole.Tail), ("pectoral", JointRole.Fin), ("dorsal", JointRole.Fin), ("disc", JointRole.Fin), ("ventral", JointRole.Fin), ("fin", JointRole.Fin),
        ("girdle", JointRole.Girdle), ("clavicle", JointRole.Girdle), ("shoulder", JointRole.Girdle),
        ("toe", JointRole.Ball), ("ball", JointRole.Ball),
        ("ankle", JointRole.Ankle), ("foot", JointRole.Ankle), ("wrist", JointRole.Ankle),
        ("upleg", JointRole.Hip), ("upperleg", JointRole.Hip), ("thigh", JointRole.Hip), ("upperarm", JointRole.Hip),
        ("knee", JointRole.Knee), ("calf", JointRole.Knee), ("shin", JointRole.Knee), ("lowerleg", JointRole.Knee), ("forearm", JointRole.Knee), ("lowerarm", JointRole.Knee), ("elbow", JointRole.Knee),
        ("hips", JointRole.Pelvis), ("pelvis", JointRole.Pelvis), ("hip", JointRole.Hip),
        ("leftleg", JointRole.Knee), ("rightleg", JointRole.Knee), ("leftarm", JointRole.Hip), ("rightarm", JointRole.Hip), ("hand", JointRole.Ankle),
        ("head", JointRole.Head), ("neck", JointRole.Neck), ("chest", JointRole.Chest), ("spine", JointRole.Spine), ("torso", JointRole.Spine), ("abdomen", JointRole.Spine), ("waist", JointRole.Spine), ("root", JointRole.Root), ("body", JointRole.Body),
    };

    /// <summary>What a joint of this name is; <see cref="JointRole.Other"/> if the name does not say.</summary>
    public static JointRole RoleOf(string name)
    {
        string plain = Plain(name ?? throw new ArgumentNullException(nameof(name)));
        string[] parts = name.ToLowerInvariant().Split(' ', '_', '.', '-', ':');
        foreach ((string word, JointRole role) in words)
        {
            // "end" and "ear" are parts of other words, as bend and forearm.
            bool whole = word.Length > 3 || word == "toe" || Array.IndexOf(parts, word) >= 0 || plain.StartsWith(word, StringComparison.Ordinal) || (word is "end" or "nub" or "jaw" or "eye" or "lid" or "hip" && plain.EndsWith(word, StringComparison.Ordinal));
            if (whole && plain.Contains(word, StringComparison.Ordinal))
            {
                return role;
            }
        }

        return JointRole.Other;
    }

    /// <summary>Whether a name says that a joint is part of a limb without saying which: <c>leg_joint_L_2</c>.</summary>
    internal static bool SaysLimb(string name)
    {
        string plain = Plain(name);
        if (Array.Exists(words, one => one.Role == JointRole.Other && plain.Contains(one.Word, StringComparison.Ordinal)))
        {
            return false;
        }

        return plain.Contains("leg", StringComparison.Ordinal)
            || (plain.Contains("arm", StringComparison.Ordinal) && !plain.Contains("armature", StringComparison.Ordinal) && !plain.Contains("armo", StringComparison.Ordinal));
    }

    /// <summary>On what side a joint of this name is; the midline if the name does not say.</summary>
    public static Side SideOf(string name)
    {
        string text = name ?? throw new ArgumentNullException(nameof(name));
        if (text.Contains("Left", StringComparison.OrdinalIgnoreCase))
        {
            return Side.Left;
        }

        if (text.Contains("Right", StringComparison.OrdinalIgnoreCase))
        {
            return Side.Right;
        }

        foreach (string part in text.Split('_', '.', ' ', '-', ':'))
        {
            string letters = part.TrimEnd('0', '1', '2', '3', '4', '5', '6', '7', '8', '9');
            if (letters is "L" or "l")
            {
                return Side.Left;
            }

            if (letters is "R" or "r")
            {
                return Side.Right;
            }
        }

        return Side.Median;
    }

    /// <summary>Lower-case letters alone; what is before a colon is the name of the character.</summary>
    private static string Plain(string name)
    {
        var plain = new System.Text.StringBuilder(name.Length);
        foreach (char c in name.Substring(name.LastIndexOf(':') + 1))
        {
            if (char.IsLetter(c))
            {
                plain.Append(char.ToLowerInvariant(c));
            }
        }

        return plain.ToString();
    }
}
