using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;
using CreatureGen.Tests.Conventions;

namespace CreatureGen.Tests.Documents;

/// <summary>A piece of C# in a document.</summary>
/// <param name="Document">Path from the top of the repository.</param>
/// <param name="Line">Its first line, from 1.</param>
/// <param name="Code">What stands there.</param>
internal sealed record DocumentBlock(string Document, int Line, string Code)
{
    /// <summary>Where it is.</summary>
    public override string ToString() => FormattableString.Invariant($"{Document}:{Line}");
}

/// <summary>What the tests read of the documents.</summary>
internal static class DocumentText
{
    /// <summary>Paths of all documents from the top of the repository, with forward slashes.</summary>
    public static IReadOnlyList<string> All { get; } = Directory.GetFiles(RepositoryFiles.Root, "*.md")
        .Concat(Directory.GetFiles(Path.Combine(RepositoryFiles.Root, "docs"), "*.md", SearchOption.AllDirectories))
        .Select(path => Path.GetRelativePath(RepositoryFiles.Root, path).Replace('\\', '/'))
        .Order(StringComparer.Ordinal)
        .ToArray();

    /// <summary>All of a document.</summary>
    public static string Read(string document) => File.ReadAllText(Path.Combine(RepositoryFiles.Root, document));

    /// <summary>Its pieces of C#.</summary>
    public static IEnumerable<DocumentBlock> Blocks(string document)
    {
        string text = Read(document).ReplaceLineEndings("\n");
        foreach (Match match in Regex.Matches(text, "^```(?:csharp|cs|c#)\n(.*?)^```", RegexOptions.Singleline | RegexOptions.Multiline))
        {
            yield return new DocumentBlock(document, 2 + text[..match.Index].Count(letter => letter == '\n'), match.Groups[1].Value);
        }
    }

    /// <summary>Targets of its links and pictures, without those of other sites.</summary>
    public static IEnumerable<string> Links(string document) =>
        Regex.Matches(WithoutCode(Read(document)), @"\]\(([^)\s]+)\)").Select(match => match.Groups[1].Value).Where(link => !link.Contains("://", StringComparison.Ordinal) && !link.StartsWith("mailto:", StringComparison.Ordinal));

    /// <summary>The names that links give to its headings.</summary>
    public static IReadOnlyList<string> Anchors(string document) =>
        Regex.Matches(WithoutCode(Read(document)), @"^#+\s+(.+?)\s*$", RegexOptions.Multiline).Select(match => Anchor(match.Groups[1].Value)).ToArray();

    private static string WithoutCode(string text) => Regex.Replace(text, "^```.*?^```", "", RegexOptions.Singleline | RegexOptions.Multiline);

    /// <summary>Lower case, spaces to hyphens, nothing but letters, digits, hyphens and underscores.</summary>
    private static string Anchor(string heading)
    {
        var anchor = new StringBuilder();
        foreach (char letter in heading.ToLowerInvariant())
        {
            anchor.Append(letter == ' ' ? "-" : char.IsLetterOrDigit(letter) || letter is '-' or '_' ? letter.ToString() : "");
        }

        return anchor.ToString();
    }
}
