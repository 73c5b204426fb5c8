using FastPoints.Entities;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>The menu <em>GameObject > Point Cloud</em>: beneath what is selected, and with Undo.</summary>
    static class SceneMenu
    {
        const string Menu = "GameObject/Point Cloud/";
        const int Priority = 10;

        [MenuItem(Menu + "Point Cloud", false, Priority)]
        static void AddCloud(MenuCommand command) => Add<PointCloud>("Point Cloud", command);

        [MenuItem(Menu + "Origin", false, Priority)]
        static void AddOrigin(MenuCommand command) => Add<PointCloudOrigin>("Point Cloud Origin", command);

        [MenuItem(Menu + "Clip Box", false, Priority)]
        static void AddClipBox(MenuCommand command) => Add<PointCloudClipBox>("Point Cloud Clip Box", command);

        [MenuItem(Menu + "Settings", false, Priority)]
        static void AddSettings(MenuCommand command) => Add<PointCloudSettings>("Point Cloud Settings", command);

        // No drop handler is given a link that is dragged from a browser.
        [MenuItem(Menu + "Cloud of Copied Link", false, Priority)]
        static void AddLinked(MenuCommand command) =>
            Add<PointCloud>(SourcePath.NameOf(CopiedLink), command).Path = CopiedLink;

        [MenuItem(Menu + "Cloud of Copied Link", true, Priority)]
        static bool CanAddLinked() => SourcePath.IsRemote(CopiedLink);

        static string CopiedLink => (GUIUtility.systemCopyBuffer ?? "").Trim();

        static T Add<T>(string name, MenuCommand command)
            where T : Component
        {
            var made = ObjectFactory.CreateGameObject(name);
            var component = ObjectFactory.AddComponent<T>(made);
            // In a prefab stage it is added to the prefab, with a default parent under that.
            ObjectFactory.PlaceGameObject(made, command.context as GameObject);
            return component;
        }
    }
}
