using System;

namespace CreatureGen.Preview.Pictures;

/// <summary>Size of the letters of a <see cref="Label"/>.</summary>
public enum LabelSize
{
    /// <summary>Capitals are 7 pixels high.</summary>
    Small = 1,

    /// <summary>Capitals are 14 pixels high.</summary>
    Medium = 2,

    /// <summary>Capitals are 28 pixels high.</summary>
    Large = 4,
}

/// <summary>Draws lines of text on pictures in crisp letters. Printable ASCII; any other character is drawn as a question mark.</summary>
public static class Label
{
    // Gaps in font pixels.
    private const int LetterGap = 1;
    private const int LineGap = 3;

    /// <summary>Pixels from the left edge of the first letter to the right edge of the last.</summary>
    public static int Width(string text, LabelSize size)
    {
        ArgumentNullException.ThrowIfNull(text);
        int width = 0;
        foreach (char letter in text)
        {
            width += BitmapFont.Width(letter) + LetterGap;
        }

        return Math.Max(0, width - LetterGap) * (int)size;
    }

    /// <summary>Pixels from the top of one line to the top of the next.</summary>
    public static int LineHeight(LabelSize size) => (BitmapFont.Rows + LineGap) * (int)size;

    /// <summary>The text, or as much of its start with two full stops after it as fits into <paramref name="width"/> pixels.</summary>
    public static string Fit(string text, LabelSize size, int width)
    {
        if (Width(text, size) <= width)
        {
            return text;
        }

        int letters = text.Length - 1;
        while (letters > 0 && Width(string.Concat(text.AsSpan(0, letters), ".."), size) > width)
        {
            letters--;
        }

        return letters > 0 ? string.Concat(text.AsSpan(0, letters), "..") : "";
    }

    /// <summary>Draws one line of text with the top left of its capitals at (<paramref name="left"/>, <paramref name="top"/>). What lies outside the picture is left out.</summary>
    /// <remarks>Larger sizes round the steps of slanting strokes (the rule of Scale2x by A. Mazzoleni, 2001).</remarks>
    public static void Draw(Picture picture, string text, int left, int top, LabelSize size, Pixel colour)
    {
        ArgumentNullException.ThrowIfNull(picture);
        ArgumentNullException.ThrowIfNull(text);
        foreach (char letter in text)
        {
            int width = BitmapFont.Width(letter);
            bool[,] ink = Ink(letter, width);
            for (int scale = (int)size; scale > 1; scale /= 2)
            {
                ink = Double(ink);
            }

            for (int y = 0; y < ink.GetLength(0); y++)
            {
                for (int x = 0; x < ink.GetLength(1); x++)
                {
                    if (ink[y, x])
                    {
                        picture.Blend(left + x, top + y, colour, 255);
                    }
                }
            }

            left += (width + LetterGap) * (int)size;
        }
    }

    private static bool[,] Ink(char letter, int width)
    {
        var ink = new bool[BitmapFont.Rows, width];
        for (int y = 0; y < BitmapFont.Rows; y++)
        {
            for (int x = 0; x < width; x++)
            {
                ink[y, x] = ((BitmapFont.Ink(letter, y) >> x) & 1) != 0;
            }
        }

        return ink;
    }

    private static bool[,] Double(bool[,] source)
    {
        int height = source.GetLength(0);
        int width = source.GetLength(1);
        var doubled = new bool[height * 2, width * 2];
        for (int y = 0; y < height; y++)
        {
            for (int x = 0; x < width; x++)
            {
                bool centre = source[y, x];
                bool up = y > 0 && source[y - 1, x];
                bool down = y + 1 < height && source[y + 1, x];
                bool left = x > 0 && source[y, x - 1];
                bool right = x + 1 < width && source[y, x + 1];
                bool flat = up == down || left == right;
                doubled[2 * y, 2 * x] = flat || left != up ? centre : left;
                doubled[2 * y, (2 * x) + 1] = flat || up != right ? centre : right;
                doubled[(2 * y) + 1, 2 * x] = flat || left != down ? centre : left;
                doubled[(2 * y) + 1, (2 * x) + 1] = flat || down != right ? centre : right;
            }
        }

        return doubled;
    }
}
