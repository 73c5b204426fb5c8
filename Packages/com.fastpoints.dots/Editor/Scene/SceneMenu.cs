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

        static void Add<T>(string name, MenuCommand command)
            where T : Component
        {
            var made = ObjectFactory.CreateGameObject(name);
            ObjectFactory.AddComponent<T>(made);
            // In a prefab stage it is added to the prefab, with a default parent under that.
            ObjectFactory.PlaceGameObject(made, command.context as GameObject);
        }
    }
}
