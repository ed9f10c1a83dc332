using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Xml.Linq;

namespace CreatureGen.Reference;

/// <summary>XML documentation without what users cannot see.</summary>
internal static class OpenDocumentation
{
    /// <summary>Removes from a file all that is not public in an assembly.</summary>
    /// <returns>How many entries stay and how many went.</returns>
    public static (int Kept, int Removed) Trim(Assembly assembly, string path)
    {
        HashSet<string> open = OpenMembers.TypesOf(assembly).SelectMany(type => OpenMembers.Of(type).Prepend(type)).Select(DocumentationId.Of).ToHashSet(StringComparer.Ordinal);
        XDocument document = XDocument.Load(path, LoadOptions.PreserveWhitespace);
        XElement[] all = document.Descendants("member").ToArray();
        XElement[] closed = all.Where(member => !open.Contains(member.Attribute("name")!.Value)).ToArray();
        foreach (XElement member in closed)
        {
            if (member.PreviousNode is XText space)
            {
                space.Remove();
            }

            member.Remove();
        }

        document.Save(path, SaveOptions.DisableFormatting);
        return (all.Length - closed.Length, closed.Length);
    }
}
