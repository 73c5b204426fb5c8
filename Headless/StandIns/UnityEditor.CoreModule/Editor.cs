using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    [AttributeUsage(AttributeTargets.Class)]
    public class CustomEditor : Attribute
    {
        public CustomEditor(Type inspectedType)
        {
        }

        public CustomEditor(Type inspectedType, bool editorForChildClasses)
        {
        }
    }

    [AttributeUsage(AttributeTargets.Class)]
    public sealed class CanEditMultipleObjects : Attribute
    {
    }

    public class Editor : ScriptableObject
    {
        public Object target { get; set; }

        public Object[] targets => new[] { target };

        public SerializedObject serializedObject => new SerializedObject();

        public virtual bool RequiresConstantRepaint() => false;

        public virtual Texture2D RenderStaticPreview(string assetPath, Object[] subAssets, int width, int height) => null;

        public virtual void OnInspectorGUI()
        {
        }

        public static void CreateCachedEditor(Object targetObject, Type editorType, ref Editor previousEditor)
        {
            if (previousEditor == null || previousEditor.target != targetObject)
                previousEditor = CreateInstance<Editor>();
            previousEditor.target = targetObject;
        }

        protected static void DrawPropertiesExcluding(SerializedObject obj, params string[] propertyToExclude)
        {
        }
    }

    /// <summary>Nobody changes anything.</summary>
    public class SerializedObject
    {
        internal SerializedObject()
        {
        }

        public void Update()
        {
        }

        public bool ApplyModifiedProperties() => false;

        public SerializedProperty FindProperty(string propertyPath) => new SerializedProperty();
    }

    public class SerializedProperty
    {
    }

    [AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
    public sealed class MenuItem : Attribute
    {
        public string menuItem;
        public bool validate;
        public int priority;

        public MenuItem(string itemName)
            : this(itemName, false, 1000)
        {
        }

        public MenuItem(string itemName, bool isValidateFunction, int priority)
        {
            menuItem = itemName;
            validate = isValidateFunction;
            this.priority = priority;
        }
    }

    [AttributeUsage(AttributeTargets.Class)]
    public class FilePathAttribute : Attribute
    {
        public enum Location
        {
            PreferencesFolder = 0,
            ProjectFolder = 1,
        }

        public FilePathAttribute(string relativePath, Location location)
        {
        }
    }

    public class ScriptableSingleton<T> : ScriptableObject where T : ScriptableObject
    {
        static T s_instance;

        protected ScriptableSingleton()
        {
            s_instance = (object)this as T;
        }

        public static T instance => s_instance != null ? s_instance : CreateInstance<T>();

        protected virtual void Save(bool saveAsText)
        {
        }
    }

    public enum SettingsScope
    {
        User = 0,
        Project = 1,
    }

    [AttributeUsage(AttributeTargets.Method)]
    public sealed class SettingsProviderAttribute : Attribute
    {
    }

    public class SettingsProvider
    {
        public SettingsProvider(string path, SettingsScope scopes, IEnumerable<string> keywords = null)
        {
            settingsPath = path;
            scope = scopes;
            this.keywords = keywords;
        }

        public string settingsPath { get; }

        public SettingsScope scope { get; }

        public IEnumerable<string> keywords { get; set; }

        public Action<string> guiHandler { get; set; }
    }
}
